#include "core/files.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>

#include <libdeflate.h>

namespace unietp {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { (void)std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

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

}  // namespace

Result<std::string> read_file(const std::filesystem::path& path) {
  if (std::error_code ignored; std::filesystem::is_directory(path, ignored)) {
    return Error{Error::Kind::Io, path.string(), {}, "is a folder; expected a file"};
  }
  const File file(std::fopen(path.c_str(), "rb"));
  if (!file) return io_error(path, "cannot open for reading");
  std::string bytes;
  std::array<char, 1 << 16> buffer{};
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), file.get())) bytes.append(buffer.data(), n);
  if (std::ferror(file.get()) != 0) return io_error(path, "cannot read");
  return bytes;
}

Result<Done> write_file(const std::filesystem::path& path, std::string_view bytes) {
  std::error_code failed;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), failed);
  if (failed) return Error{Error::Kind::Io, path.string(), {}, "cannot create its folder: " + failed.message()};
  const std::filesystem::path temporary = path.string() + ".tmp";
  File file(std::fopen(temporary.c_str(), "wb"));
  if (!file) return io_error(path, "cannot open for writing");
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
  const bool closed = std::fclose(file.release()) == 0;
  if (!written || !closed) {
    const auto error = io_error(path, "cannot write");
    std::filesystem::remove(temporary, failed);
    return error;
  }
  std::filesystem::rename(temporary, path, failed);
  if (failed) {
    const Error error{Error::Kind::Io, path.string(), {}, "cannot rename into place: " + failed.message()};
    std::filesystem::remove(temporary, failed);
    return error;
  }
  return Done{};
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

}  // namespace unietp
