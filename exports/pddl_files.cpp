#include "exports/pddl_files.h"

#include <algorithm>
#include <set>

#include "core/files.h"
#include "core/text.h"
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

ActionProfile profile_with(const ActionSet& offered) {
  const auto extensions = extension_actions();
  const bool wide = std::any_of(extensions.begin(), extensions.end(), [&](const ActionInfo& action) {
    return offered[static_cast<std::size_t>(action.type)];
  });
  return wide ? ActionProfile::Wide : ActionProfile::Unietp;
}

/// Its problem, its plan and, with the first of a simulator, the domain; else why PDDL does not say it.
Result<std::optional<std::string>> say(const FinishedTask& finished, const std::vector<ValidationBackend>& backends,
                                       const fs::path& folder) {
  const TaskRecord& task = finished.record;
  const ValidationBackend& backend = backend_of(backends, finished.start);
  const Knowledge& knowledge = *backend.knowledge;
  const ActionProfile profile = profile_with(backend.profile->actions);
  const Doings doings = doings_of(finished.shown.at(Mode::M1));
  const symbolic::SceneSymbols symbols(finished.start, knowledge, profile,
                                       pddl::cast_of(finished.start, knowledge, task.goal_tree, doings.handled));
  const auto goal = symbols.goal(task.goal_tree);
  const auto problem = pddl::problem_for(task.id, finished.start.simulator, symbols.setting, symbols.start, goal);
  if (!problem) return std::optional(problem.error().message);
  const auto plan = pddl::plan_for(symbols.setting, symbols.start, goal, *problem, doings.actions, doings.pieces);
  if (!plan) return std::optional(plan.error().message);
  const auto own = folder / task.simulator;
  if (!fs::exists(own / "domain.pddl")) {
    if (auto written = write_file(own / "domain.pddl", pddl::domain_text(knowledge, profile)); !written)
      return written.error();
  }
  for (const auto& [ending, text] :
       {std::pair{".pddl", "; " + task.goal_text + "\n" + problem->text}, {".plan", join(*plan, "\n") + "\n"}})
    if (auto written = write_file(own / (task.id + ending), text); !written) return written.error();
  return std::optional<std::string>();
}

}  // namespace

Result<ExportedTasks> export_pddl(const fs::path& dataset, const std::vector<ValidationBackend>& backends,
                                  const fs::path& out) {
  return write_task_folder(dataset, {Mode::M1}, out, [&](const FinishedTask& task, const fs::path& folder) {
    return say(task, backends, folder);
  });
}

}  // namespace unietp
