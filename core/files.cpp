#include "core/files.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include <zlib.h>

namespace unietp {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { (void)std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

Error io_error(const std::filesystem::path& path, const std::string& what) {
  return {Error::Kind::Io, path.string(), {}, what + ": " + std::strerror(errno)};
}

}  // namespace

Result<std::string> read_file(const std::filesystem::path& path) {
  if (std::error_code ignored; std::filesystem::is_directory(path, ignored)) {
    return Error{Error::Kind::Io, path.string(), {}, "this is a folder; a file is expected"};
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
  if (failed) return Error{Error::Kind::Io, path.string(), {}, "cannot make its folder: " + failed.message()};
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
  z_stream stream{};
  constexpr int kGzipWindow = 15 + 16;
  // Of a scene the best compression saves 15 % of the bytes and takes five times as long.
  deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, kGzipWindow, 8, Z_DEFAULT_STRATEGY);
  std::string packed(deflateBound(&stream, static_cast<uLong>(bytes.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

Result<std::string> gunzip(std::string_view where, std::string_view bytes, std::size_t max_bytes) {
  z_stream stream{};
  constexpr int kGzipWindow = 15 + 16;
  inflateInit2(&stream, kGzipWindow);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string text;
  std::array<char, 1 << 16> buffer{};
  int status = Z_OK;
  while (status == Z_OK && text.size() <= max_bytes) {
    stream.next_out = reinterpret_cast<Bytef*>(buffer.data());
    stream.avail_out = static_cast<uInt>(buffer.size());
    status = inflate(&stream, Z_NO_FLUSH);
    text.append(buffer.data(), buffer.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (text.size() > max_bytes) {
    return Error{
        Error::Kind::Parse, std::string(where), {}, "unpacks to more than " + std::to_string(max_bytes) + " bytes"};
  }
  if (status != Z_STREAM_END) return Error{Error::Kind::Parse, std::string(where), {}, "not a whole gzip file"};
  return text;
}

Result<std::string> read_maybe_gzip(const std::filesystem::path& path) {
  auto bytes = read_file(path);
  if (!bytes || path.extension() != ".gz") return bytes;
  return gunzip(path.string(), *bytes);
}

}  // namespace unietp
