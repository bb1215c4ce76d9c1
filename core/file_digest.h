#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/result.h"

namespace unietp {

/// What tells whether a file is still the same.
struct FileDigest {
  std::uint64_t bytes = 0;
  std::string sha256;  // 64 lower-case hexadecimal digits, as core/digest.h gives them
};

/// Length and SHA-256 of a file, which is read in pieces. `path` is the user's own; the other functions cannot leave
/// the folder `root` (core/file_place.h). Errors: Io, also for what is no regular file; Schema, for an `inner` that
/// names no file of a folder.
Result<FileDigest> digest_of_file(const std::filesystem::path& path);
Result<FileDigest> digest_of_file(const std::filesystem::path& root, std::string_view inner);
/// The same of a file that is to have a length. Where it has another one, nothing is read, and `sha256` is empty.
Result<FileDigest> digest_of_file(const std::filesystem::path& root, std::string_view inner, std::uint64_t expected);

}  // namespace unietp
