#include "pipeline/export_pddl.h"

#include <map>
#include <set>

#include "core/files.h"
#include "core/text.h"
#include "pddl/cast.h"
#include "pddl/domain.h"
#include "pddl/plan.h"
#include "scene/scene_json.h"
#include "symbolic/from_scene.h"
#include "validator/task_record.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

const Knowledge* knowledge_of(const std::vector<Backend>& backends, std::string_view simulator) {
  for (const auto& backend : backends) {
    if (name_of(backend.knowledge.simulator()) == simulator) return &backend.knowledge;
  }
  return nullptr;
}

Result<std::map<std::string, DemonstrationRecord>> read_demonstrations(const fs::path& file) {
  const auto text = read_file(file);
  if (!text) return text.error();
  std::map<std::string, DemonstrationRecord> all;
  int number = 0;
  for (const auto& line : split(*text, '\n')) {
    ++number;
    if (line.empty()) continue;
    auto read = read_demonstration(file.string(), number, line);
    if (!read) return read.error();
    all[read->task] = std::move(*read);
  }
  return all;
}

/// What succeeded, what it handled, and which pieces came of what.
struct Doings {
  std::vector<Action> actions;
  std::vector<std::string> handled;
  std::vector<std::pair<std::string, std::string>> pieces;
};

/// M1 names its objects by ids.
Action action_of(const Command& command) {
  Action action;
  action.type = action_named(command.action).value_or(ActionType::Stop);
  for (const auto& argument : command.args) {
    if (!argument.id.empty()) action.args.push_back(argument.id);
  }
  return action;
}

Doings doings_of(const DemonstrationRecord& demonstration) {
  Doings all;
  std::set<std::string> known;
  for (const auto& step : demonstration.steps) {
    if (!step.success) continue;
    const auto action = action_of(step.command);
    all.handled.insert(all.handled.end(), action.args.begin(), action.args.end());
    all.actions.push_back(action);
    for (const auto& node : step.changes.nodes) {
      if (!node.slice_of.empty() && known.insert(node.id).second) all.pieces.emplace_back(node.id, node.slice_of);
    }
  }
  return all;
}

class Exporter {
 public:
  Exporter(const fs::path& dataset, const std::vector<Backend>& backends, fs::path folder)
      : dataset_(dataset), backends_(backends), folder_(std::move(folder)) {}

  Result<PddlExport> run() {
    const auto file = dataset_ / "tasks.jsonl";
    const auto text = read_file(file);
    if (!text) return text.error();
    auto demonstrations = read_demonstrations(dataset_ / "demonstrations" / "M1.jsonl");
    if (!demonstrations) return demonstrations.error();
    int number = 0;
    for (const auto& line : split(*text, '\n')) {
      ++number;
      if (line.empty()) continue;
      const auto task = read_task(file.string(), number, line);
      if (!task) return task.error();
      if (auto written = add(*task, doings_of((*demonstrations)[task->id])); !written) return written.error();
    }
    if (auto written = write_file(folder_ / "left-out.csv", left_out_); !written) return written.error();
    return made_;
  }

 private:
  Result<Done> add(const TaskRecord& task, const Doings& doings) {
    const auto* knowledge = knowledge_of(backends_, task.simulator);
    if (knowledge == nullptr)
      return Error{Error::Kind::Schema, task.id, {}, "there is no simulator \"" + task.simulator + "\""};
    const auto file = dataset_ / "scenes" / (task.scene + ".scene.json.gz");
    const auto text = read_maybe_gzip(file);
    if (!text) return text.error();
    const auto scene = scene_from_json(file.string(), *text);
    if (!scene) return scene.error();
    const symbolic::SceneSymbols symbols(*scene, *knowledge, ActionProfile::Unietp,
                                         pddl::cast_of(*scene, *knowledge, task.goal_tree, doings.handled));
    const auto goal = symbols.goal(task.goal_tree);
    const auto problem = pddl::problem_for(task.id, scene->simulator, symbols.setting, symbols.start, goal);
    if (!problem) return leave_out(task, problem.error().message);
    const auto plan = pddl::plan_for(symbols.setting, symbols.start, goal, *problem, doings.actions, doings.pieces);
    if (!plan) return leave_out(task, plan.error().message);
    const auto own = folder_ / task.simulator;
    if (!fs::exists(own / "domain.pddl")) {
      if (auto written = write_file(own / "domain.pddl", pddl::domain_text(*knowledge)); !written) return written;
    }
    if (auto written = write_file(own / (task.id + ".pddl"), "; " + task.goal_text + "\n" + problem->text); !written)
      return written;
    ++made_.problems;
    return write_file(own / (task.id + ".plan"), join(*plan, "\n") + "\n");
  }

  Done leave_out(const TaskRecord& task, const std::string& why) {
    ++made_.left_out;
    std::string quoted;
    for (const char c : why) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    left_out_ += task.id + ",\"" + quoted + "\"\n";
    return {};
  }

  const fs::path& dataset_;
  const std::vector<Backend>& backends_;
  const fs::path folder_;
  PddlExport made_;
  std::string left_out_ = "task,reason\n";
};

}  // namespace

Result<PddlExport> export_pddl(const fs::path& dataset, const std::vector<Backend>& backends, const fs::path& out) {
  std::error_code code;
  if (fs::exists(out, code))
    return Error{Error::Kind::Usage, out.string(), {}, "exists already; a new folder is expected"};
  auto aside = out;
  aside += ".partial";
  fs::remove_all(aside, code);
  auto made = Exporter(dataset, backends, aside).run();
  if (!made) {
    fs::remove_all(aside, code);
    return made.error();
  }
  fs::rename(aside, out, code);
  if (code) return Error{Error::Kind::Io, out.string(), {}, "cannot be written: " + code.message()};
  return made;
}

}  // namespace unietp
