#include "pipeline/home_files.h"

#include "core/files.h"
#include "pipeline/given_scenes.h"
#include "scene/scene_json.h"

namespace unietp {

Simulator simulator_of(const HomeInFile& home) { return home.content.simulator; }

HomesReading read_homes(const std::vector<std::filesystem::path>& paths, const std::vector<Backend>& /*backends*/) {
  HomesReading reading;
  for (const auto& file : scene_files_of(paths, reading.errors)) {
    const auto text = read_maybe_gzip(file);
    if (!text) {
      reading.errors.push_back(text.error());
    } else if (auto scene = scene_from_json(file.string(), *text)) {
      auto id = scene->id;
      reading.homes.push_back({std::move(id), std::move(*scene)});
    } else {
      reading.errors.push_back(scene.error());
    }
  }
  return reading;
}

Result<Scene> scene_of(const HomeInFile& home, const std::vector<Backend>& /*backends*/) { return home.content; }

}  // namespace unietp
