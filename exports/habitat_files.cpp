#include <algorithm>
#include <set>

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "exports/express.h"
#include "exports/formats.h"
#include "exports/habitat_episode.h"
#include "exports/own_scene.h"
#include "exports/task_folder.h"
#include "interchange/formats.h"
#include "interchange/habitat_assets.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kScenes = "scenes";

/// The folder of a Habitat scene data set as it grows, task by task.
class HabitatFolder {
 public:
  explicit HabitatFolder(const ExportRequest& request) : request_(request) {}

  Result<std::optional<std::string>> add(const FinishedTask& task, const fs::path& folder) {
    if (task.start.simulator != Simulator::Habitat) return std::optional<std::string>("not a task of Habitat");
    if (std::string why = refused_by_habitat(task); !why.empty()) return std::optional(std::move(why));
    with_own_ = with_own_ || std::any_of(task.start.nodes.begin(), task.start.nodes.end(),
                                         [](const Node& node) { return habitat_own_template(node).has_value(); });
    // Habitat adds an episode's rigid objects to the scene of the furniture.
    Scene furniture = task.start;
    furniture.id = task.record.id;
    erase_if(furniture.nodes, [](const Node& node) { return node.movable && !node.openable; });
    const auto scene = write_habitat_with_stand_ins(furniture, *backend_of(request_.backends, task.start).knowledge);
    if (!scene) return scene.error();
    std::vector<AssetFile> files = habitat_stage(furniture);
    files.push_back({std::string(kScenes) + "/" + task.record.id + ".scene_instance.json", scene->text});
    for (const Node& node : task.start.nodes) {
      if (habitat_own_template(node) || !stand_ins_.insert(habitat_stand_in_name(node)).second) continue;
      for (AssetFile& file : habitat_stand_in(node)) files.push_back(std::move(file));
    }
    episodes_.push_back(habitat_episode(task, scene->names));
    return written(files, folder, std::optional<std::string>());
  }

  Result<Done> finish(const fs::path& folder) const {
    const Json all{{"config", nullptr}, {"episodes", episodes_}};
    const std::string text = all.dump(-1, ' ', false, Json::error_handler_t::replace);
    return written({habitat_dataset_config(kScenes, with_own_), {"episodes.json.gz", gzip(text)}}, folder, Done{});
  }

 private:
  template <class Value>
  static Result<Value> written(const std::vector<AssetFile>& files, const fs::path& folder, Value value) {
    for (const AssetFile& file : files) {
      if (auto one = write_file(folder, file.path, file.content); !one) return one.error();
    }
    return value;
  }

  const ExportRequest& request_;
  std::set<std::string> stand_ins_;
  bool with_own_ = false;  // a task is in a scene of Habitat's own
  Json episodes_ = Json::array();
};

/// `episodes.json.gz` for habitat-lab, and a scene data set with stand-ins for all models that are not Habitat's own.
Result<ExportSummary> write_habitat_files(const ExportRequest& request) {
  HabitatFolder made(request);
  const auto tasks = write_task_folder(
      request.dataset, {Mode::M1}, request.out,
      [&](const FinishedTask& task, const fs::path& folder) { return made.add(task, folder); },
      [&](const fs::path& folder) { return made.finish(folder); });
  if (!tasks) return tasks.error();
  return summary_of(*tasks, request.out);
}

}  // namespace

std::string refused_by_habitat(const FinishedTask& task) {
  for (const Node& node : task.start.nodes) {
    const auto own = habitat_own_template(node);
    if (own && node.openable && node.opening > 0)
      return node.id + " is open at the start, and the joints of " + *own + " are not known";
  }
  return beyond_own_simulator(task);
}

ExportFormat habitat_format() {
  return {"habitat",
          "Habitat's scenes and habitat-lab's episodes, with models",
          {},
          true,
          write_habitat_files,
          true,
          Simulator::Habitat};
}

}  // namespace unietp
