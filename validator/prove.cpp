#include "validator/prove.h"

#include <algorithm>

#include "core/text.h"
#include "logic/evaluate.h"
#include "scene/trace.h"
#include "simulation/mode_episode.h"
#include "validator/prove_start.h"

namespace unietp {
namespace {

/// Collects what is wrong with one task.
class Findings {
 public:
  explicit Findings(const TaskFiles& files) : files_(files) {}
  void task(std::string message) { add(files_.task, std::move(message)); }
  void scene(std::string message) { add(files_.scene, std::move(message)); }
  void demonstration(std::string message) { add(files_.demonstration, std::move(message)); }
  void all(std::vector<Error> errors) {
    for (auto& error : errors) errors_.push_back(std::move(error));
  }
  std::vector<Error> take() { return std::move(errors_); }

 private:
  void add(const std::string& where, std::string message) {
    errors_.push_back({Error::Kind::Schema, where, {}, std::move(message)});
  }
  const TaskFiles& files_;
  std::vector<Error> errors_;
};

std::string text_of(const Edge& edge) {
  return std::string(info(edge.relation).name) + "(" + edge.from + ", " + edge.to + ")";
}

template <class T, class TextOf>
std::string first_difference(const std::vector<T>& recorded, const std::vector<T>& replayed, std::string_view what,
                             TextOf text) {
  for (const auto& one : recorded) {
    if (std::find(replayed.begin(), replayed.end(), one) == replayed.end())
      return "the record has " + std::string(what) + " " + text(one) + ", the replay has not";
  }
  for (const auto& one : replayed) {
    if (std::find(recorded.begin(), recorded.end(), one) == recorded.end())
      return "the replay has " + std::string(what) + " " + text(one) + ", the record has not";
  }
  return recorded == replayed ? "" : "the record has " + std::string(what) + "s in another order";
}

std::string difference_of(const Delta& recorded, const Delta& replayed) {
  std::vector<std::string> parts{
      first_difference(recorded.nodes, replayed.nodes, "the changed object", [](const Node& node) { return node.id; }),
      first_difference(recorded.removed, replayed.removed, "the removed object", [](const auto& id) { return id; }),
      first_difference(recorded.edges_added, replayed.edges_added, "the new relation", text_of),
      first_difference(recorded.edges_removed, replayed.edges_removed, "the ended relation", text_of)};
  if (recorded.agent != replayed.agent) parts.emplace_back("the agent stands, looks or holds otherwise");
  parts.erase(std::remove(parts.begin(), parts.end(), ""), parts.end());
  return join(parts, "; ");
}

std::string limits_text(Mode mode) {
  const StepLimits limits = limits_of(mode);
  return "it ends with stop(), after " + std::to_string(limits.steps) + " steps or " + std::to_string(limits.failures) +
         " failures";
}

std::string told(bool success, std::string_view failure, const std::string& feedback) {
  return success && feedback.empty() ? std::string("success") : std::string(failure) + " \"" + feedback + "\"";
}

/// Replays the steps under the rules of the mode; the changes of the replay, one delta a step. Only the first
/// difference of each kind is told: what follows from it would differ too.
std::vector<Delta> replay(ModeEpisode episode, const DemonstrationRecord& demonstration, Findings& findings) {
  std::vector<Delta> changes;
  bool same_view = true, same_outcome = true, same_changes = true;
  for (std::size_t i = 0; i < demonstration.steps.size(); ++i) {
    const auto& step = demonstration.steps[i];
    const auto at = "step " + std::to_string(i + 1) + " " + to_text(step.command) + ": ";
    if (episode.over()) {
      findings.demonstration(at + "comes after the end of the episode; " + limits_text(episode.mode()));
      break;
    }
    if (same_view && episode.visible() != step.visible) {
      same_view = false;
      findings.demonstration(at + "another view than recorded; " +
                             first_difference(step.visible, episode.visible(), "the visible object",
                                              [](const VisibleObject& object) { return object.id; }));
    }
    const Scene before = episode.world().scene();
    const auto outcome = episode.step(step.command);
    if (same_outcome && (outcome.success != step.success || name_of(outcome.failure) != step.failure ||
                         outcome.feedback != step.feedback)) {
      same_outcome = false;
      findings.demonstration(at + "recorded as " + told(step.success, step.failure, step.feedback) +
                             ", the replay gives " + told(outcome.success, name_of(outcome.failure), outcome.feedback));
    }
    auto delta = difference(before, episode.world().scene());
    if (same_changes && delta != step.changes) {
      same_changes = false;
      findings.demonstration(at + "other changes than recorded; " + difference_of(step.changes, delta));
    }
    changes.push_back(std::move(delta));
  }
  if (!episode.world().stopped()) findings.demonstration("does not end with stop()");
  return changes;
}

void check_form(const TaskRecord& task, const Scene& start, Findings& findings) {
  if (start.id != task.scene) findings.scene("is called \"" + start.id + "\", not \"" + task.scene + "\"");
  if (name_of(start.simulator) != task.simulator)
    findings.scene("is of " + std::string(name_of(start.simulator)) + ", the task of " + task.simulator);
  if (trim(task.instruction).empty()) findings.task("has no instruction");
  for (const auto& node : start.nodes) {
    if (task.instruction.find(node.id) != std::string::npos)
      findings.task("its instruction gives away the object id " + node.id);
  }
}

void check_counts(const TaskRecord& task, Mode mode, const DemonstrationRecord& demonstration, Findings& findings) {
  if (demonstration.mode != name_of(mode))
    findings.demonstration("expected the mode \"" + std::string(name_of(mode)) + "\", not \"" + demonstration.mode +
                           "\"");
  const auto steps = static_cast<int>(demonstration.steps.size());
  const auto failures = static_cast<int>(std::count_if(demonstration.steps.begin(), demonstration.steps.end(),
                                                       [](const StepRecord& step) { return !step.success; }));
  for (const TaskRecord::Count& count : task.expert) {
    if (count.mode != mode || (count.steps == steps && count.failures == failures)) continue;
    findings.task("says " + std::to_string(count.steps) + " steps and " + std::to_string(count.failures) +
                  " failures in " + std::string(name_of(mode)) + ", the demonstration has " + std::to_string(steps) +
                  " and " + std::to_string(failures));
  }
}

/// What task and demonstration both speak of.
bool compares(const TaskRecord& task, const Formula& goal) {
  return reads_comparisons(goal) ||
         std::any_of(task.start_constraints.begin(), task.start_constraints.end(), [](const auto& text) {
           return text.find("(nearest ") != std::string::npos || text.find("(size ") != std::string::npos;
         });
}

void check_start_constraints(const TaskRecord& task, const Trace& trace, const TaskFiles& files, Findings& findings) {
  for (const auto& text : task.start_constraints) {
    const auto formula = parse_formula(files.task, text, FormulaUse::State);
    if (!formula) {
      findings.task("start constraint " + text + ": " + formula.error().message);
    } else if (!holds_in(*formula, trace, 0)) {
      findings.scene("does not meet the start constraint " + text);
    }
  }
}

}  // namespace

std::vector<Error> prove_task(const TaskRecord& task, const Scene& start, const ValidationBackend& backend,
                              const ValidationOptions& options, const TaskFiles& files) {
  Findings findings(files);
  check_form(task, start, findings);
  findings.all(prove_start(start, options.rest_m, files.scene));

  const auto goal = parse_formula(files.task, task.goal_text, FormulaUse::Goal);
  if (!goal) {
    findings.task("its goal does not read, at column " + std::to_string(goal.error().pos.column) +
                  " of the text: " + goal.error().message);
  } else if (*goal != task.goal_tree) {
    findings.task("its goal's text and tree are different formulas: " + task.goal_text + " against " +
                  to_text(task.goal_tree));
  }
  if (const auto world = World::create(start, *backend.knowledge, *backend.profile); !world) {
    findings.scene("cannot be rebuilt: " + world.error().message);
    return findings.take();
  }
  if (!goal) return findings.take();
  const auto at_start = to_logic(start, {}, compares(task, *goal));
  check_start_constraints(task, at_start, files, findings);
  if (holds(*goal, at_start)) findings.scene("its goal holds before anything is done");
  return findings.take();
}

std::vector<Error> prove_demonstration(const TaskRecord& task, const Scene& start, Mode mode,
                                       const DemonstrationRecord& demonstration, const ValidationBackend& backend,
                                       const TaskFiles& files) {
  Findings findings(files);
  check_counts(task, mode, demonstration, findings);
  auto world = World::create(start, *backend.knowledge, *backend.profile);
  if (!world) return findings.take();
  const auto changes = replay({std::move(*world), mode}, demonstration, findings);
  const auto goal = parse_formula(files.task, task.goal_text, FormulaUse::Goal);
  if (!goal) return findings.take();
  const auto trace = to_logic(start, changes, compares(task, *goal));
  for (const auto& domain : empty_domains(*goal, trace))
    findings.task("its goal speaks of all or a number of " + domain + ", of which the scene has none");
  if (!holds(*goal, trace)) findings.demonstration("its replay does not reach the goal " + task.goal_text);
  return findings.take();
}

}  // namespace unietp
