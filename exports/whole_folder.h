#pragma once

#include <filesystem>
#include <functional>

#include "core/result.h"

namespace unietp {

/// Has a folder written aside, "<out>.partial", and gives it its name when all of it is there. What an earlier run left
/// aside is removed first. Errors: Usage for an `out` that exists, Io, and those of `write`; then nothing stays.
Result<Done> write_whole_folder(const std::filesystem::path& out,
                                const std::function<Result<Done>(const std::filesystem::path& aside)>& write);

}  // namespace unietp
