#include "core/file_digest.h"

#include <array>
#include <fstream>
#include <memory>
#include <string_view>

#include <openssl/evp.h>
#include <openssl/sha.h>

namespace unietp {

Result<FileDigest> digest_of_file(const std::filesystem::path& path) {
  const auto failure = [&path] { return Error{Error::Kind::Io, path.string(), {}, "cannot be read"}; };
  std::ifstream file(path, std::ios::binary);
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(), &EVP_MD_CTX_free);
  if (!file || !context || EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) != 1) return failure();
  FileDigest digest;
  std::string block(std::size_t{1} << 18, '\0');
  while (file) {
    file.read(block.data(), static_cast<std::streamsize>(block.size()));
    const auto count = static_cast<std::size_t>(file.gcount());
    if (EVP_DigestUpdate(context.get(), block.data(), count) != 1) return failure();
    digest.bytes += count;
  }
  std::array<unsigned char, SHA256_DIGEST_LENGTH> hash{};
  if (file.bad() || EVP_DigestFinal_ex(context.get(), hash.data(), nullptr) != 1) return failure();
  constexpr std::string_view kDigits = "0123456789abcdef";
  for (const unsigned char byte : hash) {
    digest.sha256 += kDigits[byte >> 4];
    digest.sha256 += kDigits[byte & 15];
  }
  return digest;
}

}  // namespace unietp
