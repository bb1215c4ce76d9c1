#pragma once

#include <filesystem>
#include <string>

#include "core/folder_lock.h"
#include "core/result.h"
#include "scene/scene.h"

namespace unietp {

/// Makes the folder, checks that files can be written to it, and takes the right to fill it file by file: two commands
/// at once would leave the homes of both. Errors: Io; Usage when another process has the right.
Result<FolderLock> prepare_folder(const std::filesystem::path& folder);

/// `<id>.scene.json.gz`.
std::string scene_file_name(const std::string& id);
/// Writes a scene into the folder, completely or not at all. Errors: Io.
Result<Done> write_scene(const std::filesystem::path& folder, const Scene& scene);

}  // namespace unietp
