#pragma once

#include <filesystem>
#include <string>

#include "core/result.h"
#include "scene/scene.h"

namespace unietp {

/// Makes the folder and checks that files can be written to it. Errors: Io.
Result<Done> prepare_folder(const std::filesystem::path& folder);

/// `<id>.scene.json.gz`.
std::string scene_file_name(const std::string& id);
/// Writes a scene into the folder, completely or not at all. Errors: Io.
Result<Done> write_scene(const std::filesystem::path& folder, const Scene& scene);

}  // namespace unietp
