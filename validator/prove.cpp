#include "validator/prove.h"

#include <algorithm>

#include "core/text.h"
#include "logic/evaluate.h"
#include "scene/trace.h"
#include "validator/prove_start.h"

namespace unietp {
namespace {

constexpr std::size_t kMaxSteps = 50;  // of a demonstration in M1 and M2
constexpr int kMaxFailures = 10;

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

/// Replays the steps; the changes of the replay, one delta a step. Only the first difference of each kind is told: what
/// follows from it would differ too.
std::vector<Delta> replay(World world, const DemonstrationRecord& demonstration, Findings& findings) {
  std::vector<Delta> changes;
  bool same_view = true, same_outcome = true, same_changes = true;
  for (std::size_t i = 0; i < demonstration.steps.size(); ++i) {
    const auto& step = demonstration.steps[i];
    const auto at = "step " + std::to_string(i + 1) + " " + to_text(step.action) + ": ";
    if (same_view && world.visible() != step.visible) {
      same_view = false;
      const auto told = first_difference(step.visible, world.visible(), "the visible object",
                                         [](const VisibleObject& object) { return object.id; });
      findings.demonstration(at + "another view than recorded; " + told);
    }
    const Scene before = world.scene();
    const auto outcome = world.step(step.action);
    if (same_outcome && (outcome.success != step.success || name_of(outcome.failure) != step.failure ||
                         outcome.feedback != step.feedback)) {
      same_outcome = false;
      const auto told = [](bool success, std::string_view failure, const std::string& feedback) {
        return success && feedback.empty() ? std::string("success") : std::string(failure) + " \"" + feedback + "\"";
      };
      findings.demonstration(at + "recorded as " + told(step.success, step.failure, step.feedback) +
                             ", the replay gives " + told(outcome.success, name_of(outcome.failure), outcome.feedback));
    }
    auto delta = difference(before, world.scene());
    if (same_changes && delta != step.changes) {
      same_changes = false;
      findings.demonstration(at + "other changes than recorded; " + difference_of(step.changes, delta));
    }
    changes.push_back(std::move(delta));
  }
  if (!world.stopped()) findings.demonstration("does not end with stop()");
  return changes;
}

void check_form(const TaskRecord& task, const Scene& start, const DemonstrationRecord& demonstration,
                Findings& findings) {
  if (demonstration.mode != "M1")
    findings.demonstration("expected the mode \"M1\", not \"" + demonstration.mode + "\"");
  if (start.id != task.scene) findings.scene("is called \"" + start.id + "\", not \"" + task.scene + "\"");
  if (name_of(start.simulator) != task.simulator)
    findings.scene("is of " + std::string(name_of(start.simulator)) + ", the task of " + task.simulator);
  const auto failures = static_cast<int>(std::count_if(demonstration.steps.begin(), demonstration.steps.end(),
                                                       [](const StepRecord& step) { return !step.success; }));
  if (task.steps != static_cast<int>(demonstration.steps.size()) || task.failures != failures)
    findings.task("says " + std::to_string(task.steps) + " steps and " + std::to_string(task.failures) +
                  " failures, the demonstration has " + std::to_string(demonstration.steps.size()) + " and " +
                  std::to_string(failures));
  if (demonstration.steps.size() > kMaxSteps || failures > kMaxFailures)
    findings.demonstration("is over the limit of 50 steps and 10 failures");
  if (trim(task.instruction).empty()) findings.task("has no instruction");
  for (const auto& node : start.nodes) {
    if (task.instruction.find(node.id) != std::string::npos)
      findings.task("its instruction gives away the object id " + node.id);
  }
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

std::vector<Error> prove_task(const TaskRecord& task, const Scene& start, const DemonstrationRecord& demonstration,
                              const ValidationBackend& backend, const ValidationOptions& options,
                              const TaskFiles& files) {
  Findings findings(files);
  check_form(task, start, demonstration, findings);
  findings.all(prove_start(start, options.rest_m, files.scene));

  const auto goal = parse_formula(files.task, task.goal_text, FormulaUse::Goal);
  if (!goal) {
    findings.task("its goal does not read, at column " + std::to_string(goal.error().pos.column) +
                  " of the text: " + goal.error().message);
  } else if (*goal != task.goal_tree) {
    findings.task("its goal's text and tree are different formulas: " + task.goal_text + " against " +
                  to_text(task.goal_tree));
  }

  auto world = World::create(start, *backend.knowledge, *backend.profile);
  if (!world) {
    findings.scene("cannot be rebuilt: " + world.error().message);
    return findings.take();
  }
  const auto changes = replay(std::move(*world), demonstration, findings);
  if (!goal) return findings.take();

  const bool compares = std::any_of(task.start_constraints.begin(), task.start_constraints.end(), [](const auto& text) {
    return text.find("(nearest ") != std::string::npos || text.find("(size ") != std::string::npos;
  });
  const bool with_comparisons = compares || reads_comparisons(*goal);
  const auto at_start = to_logic(start, {}, with_comparisons);
  check_start_constraints(task, at_start, files, findings);
  if (holds(*goal, at_start)) findings.scene("its goal holds before anything is done");
  const auto trace = to_logic(start, changes, with_comparisons);
  for (const auto& domain : empty_domains(*goal, trace))
    findings.task("its goal speaks of all or a number of " + domain + ", of which the scene has none");
  if (!holds(*goal, trace)) findings.demonstration("its replay does not reach the goal " + task.goal_text);
  return findings.take();
}

}  // namespace unietp
