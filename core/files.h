#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/limits.h"
#include "core/result.h"

namespace unietp {

/// Whole file as bytes. `path` is the user's own; what names in a file lead to is read with the second function, which
/// cannot leave the folder `root` (core/file_place.h). Errors: Io, naming the file and the system's reason; also for
/// what is no regular file or has more than limits::kFileBytes. Schema, for an `inner` that names no file of a folder.
Result<std::string> read_file(const std::filesystem::path& path);
Result<std::string> read_file(const std::filesystem::path& root, std::string_view inner);

/// Writes to `<path>.tmp` and renames, so that readers see the old bytes or the new, never half; makes parent folders.
/// The second function cannot leave the folder `root`. Errors: Io (and the temporary file is removed); Schema, as
/// above.
Result<Done> write_file(const std::filesystem::path& path, std::string_view bytes);
Result<Done> write_file(const std::filesystem::path& root, std::string_view inner, std::string_view bytes);

/// RFC 1952 gzip without name and time, so that equal input gives equal bytes.
std::string gzip(std::string_view bytes);

/// Errors: Parse when the bytes are not gzip, are cut, or unpack to more than `max_bytes`. `where` names the source.
Result<std::string> gunzip(std::string_view where, std::string_view bytes,
                           std::size_t max_bytes = limits::kUnpackedBytes);

/// read_file, then gunzip when the name ends in .gz.
Result<std::string> read_maybe_gzip(const std::filesystem::path& path);
Result<std::string> read_maybe_gzip(const std::filesystem::path& root, std::string_view inner);

}  // namespace unietp
