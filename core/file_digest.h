#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/result.h"

namespace unietp {

struct FileDigest {
  std::uint64_t bytes = 0;
  std::string sha256;  // 64 lower-case hexadecimal digits, as core/digest.h gives them
};

/// Length and SHA-256 of a file, which is read in pieces. Errors: Io.
Result<FileDigest> digest_of_file(const std::filesystem::path& path);

}  // namespace unietp
