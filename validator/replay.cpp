#include "validator/replay.h"

#include <algorithm>

#include "core/text.h"
#include "simulation/mode_episode.h"

namespace unietp {
namespace {

template <class T, class TextOf>
std::string first_difference(const std::vector<T>& recorded, const std::vector<T>& replayed, std::string_view what,
                             TextOf text) {
  for (const auto& one : recorded) {
    if (std::find(replayed.begin(), replayed.end(), one) == replayed.end())
      return "the record has " + std::string(what) + " " + text(one) + ", the replay does not";
  }
  for (const auto& one : replayed) {
    if (std::find(recorded.begin(), recorded.end(), one) == recorded.end())
      return "the replay has " + std::string(what) + " " + text(one) + ", the record does not";
  }
  return recorded == replayed ? "" : "the record has " + std::string(what) + "s in a different order";
}

std::string difference_of(const Delta& recorded, const Delta& replayed) {
  std::vector<std::string> parts{
      first_difference(recorded.nodes, replayed.nodes, "the changed object", [](const Node& node) { return node.id; }),
      first_difference(recorded.removed, replayed.removed, "the removed object", [](const auto& id) { return id; }),
      first_difference(recorded.edges_added, replayed.edges_added, "the new relation", text_of),
      first_difference(recorded.edges_removed, replayed.edges_removed, "the ended relation", text_of)};
  if (recorded.agent != replayed.agent) parts.emplace_back("the position, view or held objects of the agent differ");
  parts.erase(std::remove(parts.begin(), parts.end(), ""), parts.end());
  return join(parts, "; ");
}

std::string limits_text(Mode mode) {
  const StepLimits limits = rules_of(mode).limits;
  return "it ends with stop(), after " + std::to_string(limits.steps) + " steps or " + std::to_string(limits.failures) +
         " failures";
}

std::string outcome_text(bool success, std::string_view failure, const std::string& feedback) {
  return success && feedback.empty() ? std::string("success") : std::string(failure) + " \"" + feedback + "\"";
}

bool same_outcome(const StepRecord& step, const Outcome& outcome) {
  return outcome.success == step.success && name_of(outcome.failure) == step.failure &&
         outcome.feedback == step.feedback;
}

/// What one step changed: as a whole, and from moment to moment where it passed through several.
struct StepChanges {
  Delta whole;
  std::vector<Delta> moments;
};

StepChanges changes_of(const World& world) {
  StepChanges made{world.changes(), {}};
  if (!world.passed().empty()) made.moments = world.changes_by_moment();
  return made;
}

/// What is wrong with the recorded changes, or "".
std::string fault_of(const StepRecord& step, const StepChanges& made) {
  if (made.whole != step.changes)
    return "the changes differ from the record; " + difference_of(step.changes, made.whole);
  if (made.moments.size() != step.moments.size())
    return "the record has " + std::to_string(step.moments.size()) + " moments, the replay " +
           std::to_string(made.moments.size());
  for (std::size_t i = 0; i < made.moments.size(); ++i) {
    if (made.moments[i] != step.moments[i])
      return "the changes of moment " + std::to_string(i + 1) + " differ from the record; " +
             difference_of(step.moments[i], made.moments[i]);
  }
  return "";
}

/// The action of a command, with objects by their ids: a box stands for the visible object that it overlaps most.
Action action_of(const Command& command, ActionType type, const std::vector<VisibleObject>& view) {
  Action action{type, {}};
  for (const Argument& argument : command.args) {
    if (!argument.box) {
      action.args.push_back(argument.id);
      continue;
    }
    const auto best = std::max_element(view.begin(), view.end(), [&](const auto& a, const auto& b) {
      return overlap_of(*argument.box, a.box) < overlap_of(*argument.box, b.box);
    });
    action.args.push_back(best == view.end() ? "" : best->id);
  }
  return action;
}

}  // namespace

std::string text_of(const Edge& edge) {
  return std::string(info(edge.relation).name) + "(" + edge.from + ", " + edge.to + ")";
}

Replay replay(const World& start, Mode mode, const DemonstrationRecord& demonstration, const std::string& where) {
  Replay done;
  bool view_reported = false, outcome_reported = false, changes_reported = false;
  const auto found = [&](ProblemKind kind, std::string message) {
    done.problems.push_back(problem_in(kind, where, std::move(message)));
  };
  ModeEpisode episode(start, mode);
  for (std::size_t i = 0; i < demonstration.steps.size(); ++i) {
    const auto& step = demonstration.steps[i];
    const auto at = "step " + std::to_string(i + 1) + " " + to_text(step.command) + ": ";
    if (episode.over()) {
      found(ProblemKind::AfterEnd, at + "comes after the end of the episode; " + limits_text(mode));
      break;
    }
    if (!view_reported && episode.visible() != step.visible) {
      view_reported = true;
      found(ProblemKind::View, at + "the view differs from the record; " +
                                   first_difference(step.visible, episode.visible(), "the visible object",
                                                    [](const VisibleObject& object) { return object.id; }));
    }
    const auto type = action_named(step.command.action);
    if (type && *type != ActionType::Stop) done.plan.push_back(action_of(step.command, *type, step.visible));
    const auto outcome = episode.step(step.command);
    if (!outcome_reported && !same_outcome(step, outcome)) {
      outcome_reported = true;
      found(ProblemKind::Outcome, at + "recorded as " + outcome_text(step.success, step.failure, step.feedback) +
                                      ", the replay gives " +
                                      outcome_text(outcome.success, name_of(outcome.failure), outcome.feedback));
    }
    const StepChanges made = outcome.success ? changes_of(episode.world()) : StepChanges();
    if (const auto fault = fault_of(step, made); !changes_reported && !fault.empty()) {
      changes_reported = true;
      found(ProblemKind::Changes, at + fault);
    }
    if (made.moments.empty()) done.changes.push_back(made.whole);
    done.changes.insert(done.changes.end(), made.moments.begin(), made.moments.end());
  }
  if (!episode.world().stopped()) found(ProblemKind::NoStop, "does not end with stop()");
  return done;
}

std::vector<Problem> check_step_count(const TaskRecord& task, Mode mode, const DemonstrationRecord& demonstration,
                                      const std::string& where) {
  const auto steps = static_cast<int>(demonstration.steps.size());
  const auto failures = static_cast<int>(std::count_if(demonstration.steps.begin(), demonstration.steps.end(),
                                                       [](const StepRecord& step) { return !step.success; }));
  std::vector<Problem> problems;
  for (const TaskRecord::Count& count : task.expert) {
    if (count.mode != mode || (count.steps == steps && count.failures == failures)) continue;
    problems.push_back(problem_in(ProblemKind::StepCount, where,
                                  "says " + std::to_string(count.steps) + " steps and " +
                                      std::to_string(count.failures) + " failures in " + std::string(name_of(mode)) +
                                      ", the demonstration has " + std::to_string(steps) + " and " +
                                      std::to_string(failures)));
  }
  return problems;
}

}  // namespace unietp
