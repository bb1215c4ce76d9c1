#include "pipeline/given_scenes.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/digest.h"
#include "core/files.h"
#include "core/text.h"
#include "scene/scene_json.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

Error usage(const fs::path& path, std::string message) {
  return {Error::Kind::Usage, path.string(), {}, std::move(message)};
}

bool is_scene_file(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.ends_with(".scene.json") || name.ends_with(".scene.json.gz");
}

void check_categories(const fs::path& file, const Scene& scene, const Knowledge& knowledge,
                      std::vector<Error>& errors) {
  std::set<std::string> unknown;
  for (const Node& node : scene.nodes) {
    if (knowledge.find(node.category) == nullptr) unknown.insert(node.category);
  }
  if (unknown.empty()) return;
  std::vector<std::string> names;
  for (const Category& category : knowledge.categories()) names.push_back(category.name);
  for (const std::string& name : unknown) {
    const std::string near = nearest_name(name, names);
    errors.push_back(usage(file, std::string(name_of(scene.simulator)) + " has no category \"" + name + "\"" +
                                     (near.empty() ? "" : ", did you mean \"" + near + "\"") +
                                     "; `unietp knowledge show " + std::string(name_of(scene.simulator)) +
                                     "` lists all"));
  }
}

}  // namespace

std::vector<fs::path> scene_files_of(const std::vector<fs::path>& paths, std::vector<Error>& errors) {
  std::vector<fs::path> files;
  for (const fs::path& path : paths) {
    std::error_code code;
    if (!fs::is_directory(path, code)) {
      files.push_back(path);
      continue;
    }
    std::vector<fs::path> own;
    for (auto at = fs::directory_iterator(path, code); !code && at != fs::directory_iterator(); at.increment(code)) {
      if (is_scene_file(at->path())) own.push_back(at->path());
    }
    if (own.empty()) errors.push_back(usage(path, "holds no scene; expected files *.scene.json or *.scene.json.gz"));
    std::sort(own.begin(), own.end());
    files.insert(files.end(), own.begin(), own.end());
  }
  return files;
}

GivenScenes read_given_scenes(const std::vector<fs::path>& paths, const std::vector<Backend>& backends) {
  GivenScenes given;
  std::map<std::string, std::pair<fs::path, Scene>> by_id;
  std::map<std::string, std::string> digests;
  for (const fs::path& file : scene_files_of(paths, given.errors)) {
    const auto bytes = read_maybe_gzip(file);
    if (!bytes) {
      given.errors.push_back(bytes.error());
      continue;
    }
    auto scene = scene_from_json(file.string(), *bytes);
    if (!scene) {
      given.errors.push_back(scene.error());
      continue;
    }
    check_categories(file, *scene, backends[static_cast<std::size_t>(scene->simulator)].knowledge, given.errors);
    const std::string id = scene->id;
    const auto [at, fresh] = by_id.try_emplace(id, file, std::move(*scene));
    if (!fresh) {
      given.errors.push_back(
          usage(file, "has the id \"" + id + "\" of " + at->second.first.string() + "; expected one scene an id"));
    }
    digests[id] = sha256(*bytes);
  }
  for (auto& [id, scene] : by_id) {
    given.scenes.push_back(std::move(scene.second));
    given.names.push_back(id + " " + digests[id]);
  }
  return given;
}

}  // namespace unietp
