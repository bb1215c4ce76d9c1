#include "core/files.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <memory>

#include <libdeflate.h>

#include "core/file_place.h"
#include "core/file_writer.h"

namespace unietp {
namespace {

struct FreePacker {
  void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
  void operator()(libdeflate_decompressor* decompressor) const { libdeflate_free_decompressor(decompressor); }
};
using Compressor = std::unique_ptr<libdeflate_compressor, FreePacker>;
using Decompressor = std::unique_ptr<libdeflate_decompressor, FreePacker>;

/// The unpacked size that a gzip file's last four bytes state; nothing when it cannot be right.
std::size_t expected_size(std::string_view packed) {
  constexpr std::size_t kLeast = 1024, kMostFold = 1032;  // deflate cannot shrink data by more than this factor
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

/// Writes beside the file and renames. `place.name` is replaced even if it is a symbolic link, and never followed.
Result<Done> write_at(FilePlace place, std::string_view bytes) {
  auto file = FileWriter::replace(std::move(place));
  if (!file) return file.error();
  if (auto added = file->add(bytes); !added) return added;
  return file->finish();
}

/// A device or a pipe, such as /dev/stdout, takes the bytes itself: it is not to be replaced by a file.
Result<Done> write_into(const std::filesystem::path& device, std::string_view bytes) {
  auto file = FileWriter::begin(device);
  if (!file) return file.error();
  if (auto added = file->add(bytes); !added) return added;
  return file->finish();
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

Result<Done> write_file(const std::filesystem::path& asked, std::string_view bytes) {
  std::error_code failed;
  // The user's own link stays, and what it leads to is replaced.
  const bool link = std::filesystem::is_symlink(asked, failed);
  const auto path = link ? std::filesystem::weakly_canonical(asked, failed) : asked;
  if (std::filesystem::exists(path, failed) && std::filesystem::is_other(path, failed)) return write_into(path, bytes);
  failed.clear();
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), failed);
  if (failed) return Error{Error::Kind::Io, asked.string(), {}, "cannot create its folder: " + failed.message()};
  auto place = place_of(path);
  if (!place) return place.error();
  place->shown = asked;
  return write_at(std::move(*place), bytes);
}

Result<Done> write_file(const std::filesystem::path& root, std::string_view inner, std::string_view bytes) {
  auto place = place_inside(root, inner, MissingFolders::Made);
  if (!place) return place.error();
  return write_at(std::move(*place), bytes);
}

std::string gzip(std::string_view bytes) {
  // For a scene, the best compression would save another 25 % of the bytes but take ten times as long.
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
