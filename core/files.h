#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/limits.h"
#include "core/result.h"

namespace unietp {

/// Whole file as bytes. Errors: Io, naming the file and the system's reason.
Result<std::string> read_file(const std::filesystem::path& path);

/// Writes to `<path>.tmp` and renames, so that readers see the old bytes or the new, never half; makes parent folders.
/// Errors: Io (and the temporary file is removed).
Result<Done> write_file(const std::filesystem::path& path, std::string_view bytes);

/// RFC 1952 gzip without name and time, so that equal input gives equal bytes.
std::string gzip(std::string_view bytes);

/// Errors: Parse when the bytes are not gzip, are cut, or unpack to more than `max_bytes`. `where` names the source.
Result<std::string> gunzip(std::string_view where, std::string_view bytes,
                           std::size_t max_bytes = limits::kUnpackedBytes);

/// read_file, then gunzip when the name ends in .gz.
Result<std::string> read_maybe_gzip(const std::filesystem::path& path);

}  // namespace unietp
