#include "exports/pddl_files.h"

#include <map>
#include <set>

#include "core/files.h"
#include "core/text.h"
#include "exports/finished_tasks.h"
#include "exports/whole_folder.h"
#include "pddl/cast.h"
#include "pddl/domain.h"
#include "pddl/plan.h"
#include "symbolic/from_scene.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

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
  Exporter(const std::vector<ValidationBackend>& backends, const fs::path& folder)
      : backends_(backends), folder_(folder) {}

  Result<PddlExport> run(FinishedTasks tasks) {
    while (const auto lines = tasks.next()) {
      const auto task = tasks.read(*lines);
      if (!task) return task.error();
      if (auto written = add(*task); !written) return written.error();
    }
    if (auto written = write_file(folder_ / "left-out.csv", left_out_); !written) return written.error();
    return made_;
  }

 private:
  Result<Done> add(const FinishedTask& finished) {
    const TaskRecord& task = finished.record;
    const Knowledge& knowledge = *backend_of(backends_, finished.start).knowledge;
    const Doings doings = doings_of(finished.shown.at(Mode::M1));
    const symbolic::SceneSymbols symbols(finished.start, knowledge, ActionProfile::Unietp,
                                         pddl::cast_of(finished.start, knowledge, task.goal_tree, doings.handled));
    const auto goal = symbols.goal(task.goal_tree);
    const auto problem = pddl::problem_for(task.id, finished.start.simulator, symbols.setting, symbols.start, goal);
    if (!problem) return leave_out(task, problem.error().message);
    const auto plan = pddl::plan_for(symbols.setting, symbols.start, goal, *problem, doings.actions, doings.pieces);
    if (!plan) return leave_out(task, plan.error().message);
    const auto own = folder_ / task.simulator;
    if (!fs::exists(own / "domain.pddl")) {
      if (auto written = write_file(own / "domain.pddl", pddl::domain_text(knowledge)); !written) return written;
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

  const std::vector<ValidationBackend>& backends_;
  const fs::path& folder_;
  PddlExport made_;
  std::string left_out_ = "task,reason\n";
};

}  // namespace

Result<PddlExport> export_pddl(const fs::path& dataset, const std::vector<ValidationBackend>& backends,
                               const fs::path& out) {
  PddlExport made;
  const auto written = write_whole_folder(out, [&](const fs::path& aside) -> Result<Done> {
    auto tasks = FinishedTasks::open(dataset, {Mode::M1});
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
