#include <map>

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "exports/formats.h"
#include "exports/release_goal.h"
#include "exports/release_scene.h"
#include "exports/release_words.h"
#include "exports/task_folder.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string line_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n"; }

class Exporter {
 public:
  Exporter(const std::vector<ValidationBackend>& backends, const FormatFacts& facts)
      : backends_(backends), facts_(facts) {}

  Result<std::optional<std::string>> say(const FinishedTask& finished, const fs::path& folder) {
    const TaskRecord& task = finished.record;
    const Knowledge& knowledge = *backend_of(backends_, finished.start).knowledge;
    const auto goal = release_goal(task.goal_tree, finished.start, knowledge, facts_);
    if (!goal) return std::optional(goal.error().message);
    auto scene = release_scene(task.scene, finished.start, knowledge, facts_);
    if (!scene) return scene.error();
    Json references = Json::object(), referents = Json::object();
    for (const auto& [category, ids] : goal->referents) {
      for (const auto& id : ids) {
        const auto named = scene->names.find(id);
        if (named == scene->names.end()) return std::optional("the referent " + id + " has no name in their scene");
        references[category].push_back(named->second);
        referents[id] = named->second;
      }
    }
    Json own{{"task", task.id}};
    if (!scene->file.empty()) own["scene_file"] = scene->file;
    if (!referents.empty()) own["referents"] = std::move(referents);
    Json records = Json::array();
    if (scene->record) {
      records.push_back(Json::parse(*scene->record));
      if (!references.empty()) records[0]["object_reference"] = references;
      ++with_scene_;
    } else if (!references.empty()) {
      own["object_reference"] = references;
    }
    const Json element{{"split", task.split},
                       {"instruction", task.instruction},
                       {"logic_dict", Json::parse(goal->json)},
                       {"sampled_scenes", std::move(records)},
                       {"template_name", task.template_name},
                       {"unietp", std::move(own)}};
    std::string& list = lists_[finished.start.simulator];
    if (!list.empty()) list += ",\n";
    list += element.dump(-1, ' ', false, Json::error_handler_t::replace);
    scenes_ += line_of({{"task", task.id}, {"scene", task.scene}, {"not_said", scene->not_said}});
    if (scene->file.empty()) return std::optional<std::string>();
    if (auto written = write_file(folder, scene->file, scene->file_text); !written) return written.error();
    return std::optional<std::string>();
  }

  /// The lists of all tasks, and what of their scenes is not said.
  Result<Done> finish(const fs::path& folder) const {
    for (const auto& [simulator, list] : lists_) {
      if (auto written = write_file(folder, release_file(simulator), "[\n" + list + "\n]\n"); !written) return written;
    }
    return write_file(folder, "scenes.jsonl", scenes_);
  }

  std::size_t with_scene() const { return with_scene_; }

 private:
  const std::vector<ValidationBackend>& backends_;
  const FormatFacts& facts_;
  std::size_t with_scene_ = 0;
  std::map<Simulator, std::string> lists_;
  std::string scenes_;
};

/// THOR.json, VH.json, Hab.json and BEHAVIOR.json, each a list of tasks as the paper's runner reads them; scene files;
/// left_out.jsonl; and scenes.jsonl, which lists what is missing of each scene.
Result<ExportSummary> write_release(const ExportRequest& request) {
  const auto [facts, wrong] = read_format_facts(request.data / "scene_files");
  if (!wrong.empty()) return wrong.front();
  Exporter exporter(request.backends, facts);
  const auto made = write_task_folder(
      request.dataset, {}, request.out,
      [&](const FinishedTask& task, const fs::path& folder) { return exporter.say(task, folder); },
      [&](const fs::path& folder) { return exporter.finish(folder); });
  if (!made) return made.error();
  ExportSummary summary = summary_of(*made, request.out);
  summary.text = std::to_string(made->said) + " tasks in " + request.out.string() + ", " +
                 std::to_string(exporter.with_scene()) + " of them with a scene record; " +
                 std::to_string(made->left_out) + " tasks left out" + reason_lines(made->reasons);
  return summary;
}

}  // namespace

ExportFormat release_format() {
  return {"unietp-release", "the JSON format of the UniETP paper's release", {}, true, write_release, true};
}

}  // namespace unietp
