#include <algorithm>
#include <set>

#include "core/files.h"
#include "core/text.h"
#include "exports/formats.h"
#include "exports/task_folder.h"
#include "pddl/domain.h"
#include "pddl/plan.h"
#include "pddl/problem_objects.h"
#include "symbolic/from_scene.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

/// The part of a demonstration that a plan shows.
struct PlannedActions {
  std::vector<Action> actions;                              // that succeeded and do not only tidy up
  std::vector<std::string> handled;                         // ids of their arguments
  std::vector<std::pair<std::string, std::string>> pieces;  // id of a piece, id of what it was cut from
};

/// Of a command in M1, whose arguments are ids.
Action action_of(const Command& command) {
  Action action;
  action.type = action_named(command.action).value_or(ActionType::Stop);
  for (const auto& argument : command.args) {
    if (!argument.id.empty()) action.args.push_back(argument.id);
  }
  return action;
}

PlannedActions planned_actions(const DemonstrationRecord& demonstration) {
  PlannedActions all;
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

/// Writes the problem, the plan and, with the first task of a simulator, the domain. Returns why PDDL cannot express
/// the task, if so.
Result<std::optional<std::string>> say(const FinishedTask& finished, const std::vector<ValidationBackend>& backends,
                                       const fs::path& folder) {
  const TaskRecord& task = finished.record;
  const ValidationBackend& backend = backend_of(backends, finished.start);
  const Knowledge& knowledge = *backend.knowledge;
  const ActionProfile profile = profile_with(backend.profile->actions);
  const PlannedActions done = planned_actions(finished.shown.at(Mode::M1));
  const symbolic::SceneSymbols symbols(finished.start, knowledge, profile,
                                       pddl::problem_objects(finished.start, knowledge, task.goal_tree, done.handled));
  const auto goal = symbols.goal(task.goal_tree);
  const auto problem = pddl::problem_for(task.id, finished.start.simulator, symbols.setting, symbols.start, goal);
  if (!problem) return std::optional(problem.error().message);
  const auto plan = pddl::plan_for(symbols.setting, symbols.start, goal, *problem, done.actions, done.pieces);
  if (!plan) return std::optional(plan.error().message);
  const auto own = std::string(name_of(finished.start.simulator)) + "/";
  if (!fs::exists(folder / own / "domain.pddl")) {
    if (auto written = write_file(folder, own + "domain.pddl", pddl::domain_text(knowledge, profile)); !written)
      return written.error();
  }
  for (const auto& [ending, text] :
       {std::pair{".pddl", "; " + task.goal_text + "\n" + problem->text}, {".plan", join(*plan, "\n") + "\n"}})
    if (auto written = write_file(folder, own + task.id + ending, text); !written) return written.error();
  return std::optional<std::string>();
}

/// `<simulator>/domain.pddl`, `<simulator>/<task>.pddl`, the demonstration as `<simulator>/<task>.plan`,
/// left_out.jsonl.
Result<ExportSummary> write_pddl(const ExportRequest& request) {
  const auto made = write_task_folder(
      request.dataset, {Mode::M1}, request.out,
      [&](const FinishedTask& task, const fs::path& folder) { return say(task, request.backends, folder); });
  if (!made) return made.error();
  return summary_of(*made, request.out);
}

}  // namespace

ExportFormat pddl_format() {
  return {"pddl", "a PDDL domain per simulator, and a problem and a plan per task", {}, true, write_pddl, true};
}

}  // namespace unietp
