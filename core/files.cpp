#include "core/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <memory>

#include <libdeflate.h>

#include "core/file_place.h"

namespace unietp {
namespace {

struct FreePacker {
  void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
  void operator()(libdeflate_decompressor* decompressor) const { libdeflate_free_decompressor(decompressor); }
};
using Compressor = std::unique_ptr<libdeflate_compressor, FreePacker>;
using Decompressor = std::unique_ptr<libdeflate_decompressor, FreePacker>;

/// What a gzip file's last four bytes say of its size, unless they cannot be right.
std::size_t expected_size(std::string_view packed) {
  constexpr std::size_t kLeast = 1024, kMostFold = 1032;  // no deflate stream unpacks to more times its size
  std::uint32_t said = 0;
  for (std::size_t i = 0; i < 4 && i < packed.size(); ++i)
    said = (said << 8) | static_cast<unsigned char>(packed[packed.size() - 1 - i]);
  return std::clamp<std::size_t>(said, 1, std::max(kLeast, kMostFold * packed.size()));
}

Error io_error(const std::filesystem::path& path, const std::string& what) {
  return {Error::Kind::Io, path.string(), {}, what + ": " + std::strerror(errno)};
}

/// At most limits::kFileBytes; a file may have more bytes than it says (in /proc it says none), or grow.
Result<std::string> read_all(const Descriptor& file, const std::filesystem::path& path) {
  struct stat status {};
  const bool said = ::fstat(file.get(), &status) == 0 && status.st_size > 0;
  std::string bytes;
  std::size_t used = 0;
  for (std::size_t size = said ? static_cast<std::size_t>(status.st_size) : 0; size <= limits::kFileBytes;) {
    if (used == bytes.size()) bytes.resize(std::max(size + 1, used + (1 << 16)));  // one more sees the end at once
    const ssize_t count = ::read(file.get(), bytes.data() + used, bytes.size() - used);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return io_error(path, "cannot read");
    used += static_cast<std::size_t>(count);
    size = std::max(size, used);
    if (count > 0) continue;
    bytes.resize(used);
    return bytes;
  }
  return Error{Error::Kind::Io,
               path.string(),
               {},
               "has more than " + std::to_string(limits::kFileBytes) + " bytes, the most that a file may have"};
}

/// False with `errno` when not all could be written.
bool write_all(const Descriptor& file, std::string_view rest) {
  while (!rest.empty()) {
    const ssize_t count = ::write(file.get(), rest.data(), rest.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    rest.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

/// Writes beside the file and renames. `place.name` is replaced even if it is a symbolic link, and never followed.
Result<Done> write_at(const FilePlace& place, std::string_view bytes) {
  const int folder = place.folder.get();
  const std::string temporary = place.name + ".tmp";
  (void)::unlinkat(folder, temporary.c_str(), 0);  // of a run that was killed
  constexpr int kFlags = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
  Descriptor file(::openat(folder, temporary.c_str(), kFlags, 0666));
  if (file.get() < 0) return io_error(place.shown, "cannot open for writing");
  bool written = write_all(file, bytes);
  int failure = written ? 0 : errno;
  if (::close(file.release()) != 0 && written) written = false, failure = errno;
  const bool renamed = written && ::renameat(folder, temporary.c_str(), folder, place.name.c_str()) == 0;
  if (renamed) return Done{};
  if (written) failure = errno;
  (void)::unlinkat(folder, temporary.c_str(), 0);
  errno = failure;
  return io_error(place.shown, written ? "cannot rename into place" : "cannot write");
}

}  // namespace

Result<std::string> read_file(const std::filesystem::path& path) {
  const auto file = open_regular_file(path);
  if (!file) return file.error();
  return read_all(*file, path);
}

Result<std::string> read_file(const std::filesystem::path& root, std::string_view inner) {
  const auto file = open_regular_file(root, inner);
  if (!file) return file.error();
  return read_all(*file, root / inner);
}

Result<Done> write_file(const std::filesystem::path& path, std::string_view bytes) {
  std::error_code failed;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), failed);
  if (failed) return Error{Error::Kind::Io, path.string(), {}, "cannot create its folder: " + failed.message()};
  const std::string folder = path.has_parent_path() ? path.parent_path().string() : ".";
  const FilePlace place{Descriptor(::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC)), path.filename(), path};
  if (place.folder.get() < 0) return io_error(path, "cannot open its folder");
  return write_at(place, bytes);
}

Result<Done> write_file(const std::filesystem::path& root, std::string_view inner, std::string_view bytes) {
  const auto place = place_inside(root, inner, MissingFolders::Made);
  if (!place) return place.error();
  return write_at(*place, bytes);
}

std::string gzip(std::string_view bytes) {
  // Of a scene the best compression saves 25 % of the bytes and takes ten times as long.
  constexpr int kLevel = 1;
  const Compressor compressor(libdeflate_alloc_compressor(kLevel));
  std::string packed(libdeflate_gzip_compress_bound(compressor.get(), bytes.size()), '\0');
  packed.resize(libdeflate_gzip_compress(compressor.get(), bytes.data(), bytes.size(), packed.data(), packed.size()));
  return packed;
}

Result<std::string> gunzip(std::string_view where, std::string_view bytes, std::size_t max_bytes) {
  const auto refused = [&](const std::string& why) { return Error{Error::Kind::Parse, std::string(where), {}, why}; };
  const Decompressor decompressor(libdeflate_alloc_decompressor());
  std::string text;
  // A file is one member, or several in a row whose contents follow one another (RFC 1952, 2.2).
  do {
    const std::size_t begin = text.size();
    std::size_t read = 0, unpacked = 0;
    libdeflate_result result = LIBDEFLATE_INSUFFICIENT_SPACE;
    for (std::size_t room = expected_size(bytes); result == LIBDEFLATE_INSUFFICIENT_SPACE; room *= 4) {
      if (begin + room > max_bytes) room = max_bytes - begin;
      text.resize(begin + room);
      result = libdeflate_gzip_decompress_ex(decompressor.get(), bytes.data(), bytes.size(), text.data() + begin, room,
                                             &read, &unpacked);
      if (result == LIBDEFLATE_INSUFFICIENT_SPACE && begin + room == max_bytes)
        return refused("unpacks to more than " + std::to_string(max_bytes) + " bytes");
    }
    if (result != LIBDEFLATE_SUCCESS) return refused("not a whole gzip file");
    text.resize(begin + unpacked);
    bytes.remove_prefix(read);
  } while (!bytes.empty());
  return text;
}

Result<std::string> read_maybe_gzip(const std::filesystem::path& path) {
  auto bytes = read_file(path);
  if (!bytes || path.extension() != ".gz") return bytes;
  return gunzip(path.string(), *bytes);
}

Result<std::string> read_maybe_gzip(const std::filesystem::path& root, std::string_view inner) {
  auto bytes = read_file(root, inner);
  if (!bytes || !inner.ends_with(".gz")) return bytes;
  return gunzip((root / inner).string(), *bytes);
}

}  // namespace unietp
