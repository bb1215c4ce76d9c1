#include "homes/home_files.h"

#include <algorithm>

#include "core/files.h"
#include "homes/given_scenes.h"
#include "scene/scene_json.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

bool is_ours(std::string_view text) { return text.find("\"unietp-scene/") != std::string_view::npos; }

}  // namespace

Simulator simulator_of(const HomeInFile& home) {
  if (const auto* scene = std::get_if<Scene>(&home.content)) return scene->simulator;
  return std::get<ForeignHome>(home.content).source.simulator;
}

HomesReading read_homes(const std::vector<fs::path>& paths, const std::vector<Backend>& backends,
                        const FormatFacts& facts, const fs::path& models) {
  HomesReading reading;
  std::vector<fs::path> foreign;
  for (const auto& file : scene_files_of(paths, reading.errors)) {
    const auto text = read_maybe_gzip(file);
    if (!text) {
      reading.errors.push_back(text.error());
    } else if (!is_ours(*text)) {
      foreign.push_back(file);
    } else if (auto scene = scene_from_json(file.string(), *text)) {
      auto id = scene->id;
      reading.homes.push_back({std::move(id), std::move(*scene), file});
    } else {
      reading.errors.push_back(scene.error());
    }
  }
  auto others = read_foreign_scenes("auto", foreign, backends, facts, models);
  reading.errors.insert(reading.errors.end(), others.errors.begin(), others.errors.end());
  for (auto& home : others.homes) {
    auto id = home.source.id;
    auto file = home.file;
    reading.homes.push_back({std::move(id), std::move(home), std::move(file)});
  }
  return reading;
}

Result<Scene> scene_of(const HomeInFile& home, const std::vector<Backend>& backends, const FormatFacts& facts) {
  if (const auto* scene = std::get_if<Scene>(&home.content)) return *scene;
  ImportOptions options;
  options.settle = false;
  auto imported = import_home(std::get<ForeignHome>(home.content), backends, facts, options);
  if (!imported) return imported.error();
  return std::move(imported->scene);
}

}  // namespace unietp
