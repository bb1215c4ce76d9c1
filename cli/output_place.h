#pragma once

#include <filesystem>
#include <string>

namespace unietp {

/// Why no command may write to `path`: it is, or lies below, a symbolic link that leads nowhere, which would be found
/// only once all is written; or it lies inside a finished data set, shard or evaluation, or an unfinished run of this
/// program, whose files belong together. Empty when nothing speaks against it. The folder itself is none of its own
/// inside.
std::string refusal_of_output(const std::filesystem::path& path);

}  // namespace unietp
