#include "homes/scene_folder.h"

#include <unistd.h>

#include "core/files.h"
#include "scene/scene_json.h"

namespace unietp {

Result<FolderLock> prepare_folder(const std::filesystem::path& folder) {
  auto lock = FolderLock::take(folder);
  if (!lock) return lock.error();
  const auto probe = folder / ("unietp-" + std::to_string(::getpid()) + ".tmp");
  if (const auto written = write_file(probe, ""); !written) {
    return Error{
        Error::Kind::Io, folder.string(), {}, written.error().message + "; choose a folder that you can write to"};
  }
  std::error_code ignored;
  std::filesystem::remove(probe, ignored);
  return lock;
}

std::string scene_file_name(const std::string& id) { return id + ".scene.json.gz"; }

Result<Done> write_scene(const std::filesystem::path& folder, const Scene& scene) {
  return write_file(folder, scene_file_name(scene.id), gzip(scene_to_json(scene)));
}

}  // namespace unietp
