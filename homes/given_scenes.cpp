#include "homes/given_scenes.h"

#include <algorithm>
#include <set>

#include "core/digest.h"
#include "core/files.h"
#include "core/in_quotes.h"
#include "core/plain_name.h"
#include "core/text.h"
#include "homes/foreign_scenes.h"
#include "homes/home_plans.h"
#include "interchange/own_ids.h"
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

struct IdentifiedScene {
  fs::path file;
  Scene scene;
  std::string digest;
};

/// In order of id, each once.
void keep(std::vector<IdentifiedScene> found, GivenScenes& given) {
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.scene.id < b.scene.id; });
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (i > 0 && found[i].scene.id == found[i - 1].scene.id) {
      given.errors.push_back(usage(found[i].file, "has the id \"" + found[i].scene.id + "\" of " +
                                                      found[i - 1].file.string() + "; expected unique ids"));
      continue;
    }
    given.names.push_back(found[i].scene.id + " " + found[i].digest);
  }
  for (auto& one : found) given.scenes.push_back(std::move(one.scene));
}

std::vector<IdentifiedScene> read_files(const std::vector<fs::path>& paths, const std::vector<Backend>& backends,
                                        std::vector<Error>& errors) {
  std::vector<IdentifiedScene> found;
  for (const fs::path& file : scene_files_of(paths, errors)) {
    const auto bytes = read_maybe_gzip(file);
    if (!bytes) {
      errors.push_back(bytes.error());
      continue;
    }
    auto scene = scene_from_json(file.string(), *bytes);
    if (!scene) {
      errors.push_back(scene.error());
      continue;
    }
    if (!is_plain_name(scene->id))  // a data set keeps its homes in files that are called by their ids
      errors.push_back(usage(file, "has the id " + in_quotes(scene->id) + "; " + plain_name_expected()));
    check_categories(file, *scene, backends[static_cast<std::size_t>(scene->simulator)].knowledge, errors);
    auto digest = sha256(scene_to_json(*scene));  // of the text that a data set has, whoever wrote the file
    found.push_back({file, std::move(*scene), std::move(digest)});
  }
  return found;
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
    if (own.empty()) errors.push_back(usage(path, "contains no scene; expected files *.scene.json or *.scene.json.gz"));
    std::sort(own.begin(), own.end());
    files.insert(files.end(), own.begin(), own.end());
  }
  return files;
}

GivenScenes read_given_scenes(const std::vector<fs::path>& paths, const std::vector<Backend>& backends) {
  GivenScenes given;
  keep(read_files(paths, backends, given.errors), given);
  return given;
}

GivenScenes given_homes(const std::vector<fs::path>& paths_or_ids, const Resources& resources,
                        const DataFolders& folders) {
  GivenScenes given;
  std::vector<fs::path> paths;
  std::vector<std::string> ids;
  for (const auto& one : paths_or_ids) {
    std::error_code code;
    if (fs::exists(one, code) || one.has_extension() || one.has_parent_path()) {
      paths.push_back(one);
    } else {
      ids.push_back(one.string());
    }
  }
  auto found = read_files(paths, resources.backends, given.errors);
  if (ids.empty()) {
    keep(std::move(found), given);
    return given;
  }
  const HomeInputs inputs{resources.backends, resources.recipes};
  const auto homes = benchmark_homes(inputs, folders, false, ids);
  if (!homes) {
    auto error = homes.error();
    error.where = "--scenes";
    given.errors.push_back(std::move(error));
    return given;
  }
  for (const auto& home : *homes) {
    auto scene = home.make();
    if (!scene) {
      given.errors.push_back(scene.error());
      continue;
    }
    auto digest = sha256(scene_to_json(*scene));
    found.push_back({home.id, std::move(*scene), std::move(digest)});
  }
  keep(std::move(found), given);
  return given;
}

GivenScenes native_homes(const std::vector<fs::path>& paths, const fs::path& models, const Resources& resources,
                         const DataFolders& folders) {
  GivenScenes given;
  std::vector<fs::path> ours, theirs;
  for (const fs::path& path : paths) {
    std::error_code code;
    (fs::is_directory(path, code) || is_scene_file(path) ? ours : theirs).push_back(path);
  }
  auto found = read_files(ours, resources.backends, given.errors);
  const auto formats = read_format_facts(folders.scene_files());
  given.errors.insert(given.errors.end(), formats.errors.begin(), formats.errors.end());
  auto foreign = read_foreign_scenes("auto", theirs, resources.backends, formats.facts, models);
  given.errors.insert(given.errors.end(), foreign.errors.begin(), foreign.errors.end());
  if (!given.errors.empty()) return given;
  ImportOptions how;
  how.own_ids = true;
  for (const ForeignHome& home : foreign.homes) {
    auto imported = import_home(home, resources.backends, formats.facts, how);
    if (!imported) {
      given.errors.push_back(imported.error());
      continue;
    }
    auto digest = sha256(scene_to_json(imported->scene));
    found.push_back({home.file, std::move(imported->scene), std::move(digest)});
  }
  for (const auto& one : found) {
    const auto is_theirs = [&](const Node& node) { return own_id_of(node, one.scene.simulator).has_value(); };
    if (std::none_of(one.scene.nodes.begin(), one.scene.nodes.end(), is_theirs))
      given.errors.push_back(
          usage(one.file,
                "is no scene of a simulator: none of its objects has an id of that simulator; expected a "
                "simulator's file, or what `unietp scene import --own-ids` makes of one"));
  }
  keep(std::move(found), given);
  return given;
}

}  // namespace unietp
