#include "exports/release_files.h"

#include <map>

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "exports/finished_tasks.h"
#include "exports/left_out.h"
#include "exports/release_goal.h"
#include "exports/release_scene.h"
#include "exports/release_words.h"
#include "exports/whole_folder.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string line_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n"; }

class Exporter {
 public:
  Exporter(const std::vector<ValidationBackend>& backends, const fs::path& folder)
      : backends_(backends), folder_(folder) {}

  Result<ReleaseExport> run(FinishedTasks tasks) {
    while (const auto lines = tasks.next()) {
      const auto task = tasks.read(*lines);
      if (!task) return task.error();
      if (auto added = add(*task); !added) return added.error();
    }
    for (const auto& [simulator, list] : lists_) {
      if (auto ok = write_file(folder_ / release_file(simulator), "[\n" + list + "\n]\n"); !ok) return ok.error();
    }
    if (auto ok = write_file(folder_ / "left_out.jsonl", left_out_); !ok) return ok.error();
    if (auto ok = write_file(folder_ / "scenes.jsonl", scenes_); !ok) return ok.error();
    return made_;
  }

 private:
  Result<Done> add(const FinishedTask& finished) {
    const TaskRecord& task = finished.record;
    const Knowledge& knowledge = *backend_of(backends_, finished.start).knowledge;
    const auto goal = release_goal(task.goal_tree, finished.start, knowledge);
    if (!goal) return leave_out(task, goal.error().message);
    auto scene = release_scene(task.scene, finished.start, knowledge);
    if (!scene) return scene.error();
    Json references = Json::object(), referents = Json::object();
    for (const auto& [category, ids] : goal->referents) {
      for (const auto& id : ids) {
        const auto named = scene->names.find(id);
        if (named == scene->names.end()) return leave_out(task, id + ", which is meant, has no name in their scene");
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
      ++made_.with_scene;
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
    ++made_.tasks;
    scenes_ += line_of({{"task", task.id}, {"scene", task.scene}, {"not_said", scene->not_said}});
    return scene->file.empty() ? Done{} : write_file(folder_ / scene->file, scene->file_text);
  }

  Done leave_out(const TaskRecord& task, const std::string& why) {
    ++made_.left_out;
    left_out_ += left_out_line(task, why);
    return {};
  }

  const std::vector<ValidationBackend>& backends_;
  const fs::path& folder_;
  ReleaseExport made_;
  std::map<Simulator, std::string> lists_;
  std::string left_out_, scenes_;
};

}  // namespace

Result<ReleaseExport> export_release(const fs::path& dataset, const std::vector<ValidationBackend>& backends,
                                     const fs::path& out) {
  ReleaseExport made;
  const auto written = write_whole_folder(out, [&](const fs::path& aside) -> Result<Done> {
    auto tasks = FinishedTasks::open(dataset, {});
    if (!tasks) return tasks.error();
    const auto done = Exporter(backends, aside).run(std::move(*tasks));
    if (!done) return done.error();
    made = *done;
    return Done{};
  });
  if (!written) return written.error();
  return made;
}

}  // namespace unietp
