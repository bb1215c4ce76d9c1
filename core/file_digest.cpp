#include "core/file_digest.h"

#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <memory>
#include <string_view>

#include <openssl/evp.h>
#include <openssl/sha.h>

#include "core/file_place.h"

namespace unietp {

namespace {

Result<FileDigest> digest_of(const Descriptor& file, const std::filesystem::path& path) {
  const auto failure = [&path] { return Error{Error::Kind::Io, path.string(), {}, "cannot be read"}; };
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(), &EVP_MD_CTX_free);
  if (!context || EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) != 1) return failure();
  FileDigest digest;
  std::string block(std::size_t{1} << 18, '\0');
  for (;;) {
    const ssize_t count = ::read(file.get(), block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return failure();
    if (count == 0) break;
    if (EVP_DigestUpdate(context.get(), block.data(), static_cast<std::size_t>(count)) != 1) return failure();
    digest.bytes += static_cast<std::uint64_t>(count);
  }
  std::array<unsigned char, SHA256_DIGEST_LENGTH> hash{};
  if (EVP_DigestFinal_ex(context.get(), hash.data(), nullptr) != 1) return failure();
  constexpr std::string_view kDigits = "0123456789abcdef";
  for (const unsigned char byte : hash) {
    digest.sha256 += kDigits[byte >> 4];
    digest.sha256 += kDigits[byte & 15];
  }
  return digest;
}

}  // namespace

Result<FileDigest> digest_of_file(const std::filesystem::path& path) {
  const auto file = open_regular_file(path);
  if (!file) return file.error();
  return digest_of(*file, path);
}

Result<FileDigest> digest_of_file(const std::filesystem::path& root, std::string_view inner) {
  const auto file = open_regular_file(root, inner);
  if (!file) return file.error();
  return digest_of(*file, root / inner);
}

Result<FileDigest> digest_of_file(const std::filesystem::path& root, std::string_view inner, std::uint64_t expected) {
  const auto file = open_regular_file(root, inner);
  if (!file) return file.error();
  struct stat about = {};
  if (::fstat(file->get(), &about) != 0)
    return Error{Error::Kind::Io, (root / inner).string(), {}, "cannot be looked at"};
  const auto bytes = static_cast<std::uint64_t>(about.st_size);
  if (bytes != expected) return FileDigest{bytes, ""};
  return digest_of(*file, root / inner);
}

}  // namespace unietp
