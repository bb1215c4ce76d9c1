#include "validator/search_check.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "logic/constraints.h"
#include "logic/evaluate.h"
#include "simulation/mode_episode.h"

namespace unietp {
namespace {

/// An episode of an agent with full information, and what it has changed so far.
struct InformedEpisode {
  ModeEpisode episode;
  std::vector<Delta> changes;

  bool act(const Command& command) {
    const bool done = episode.step(command).success;
    if (!done) return false;
    for (Delta& change : episode.world().changes_by_moment()) changes.push_back(std::move(change));
    return true;
  }
};

bool moves_the_body(ActionType type) {
  const ActionClass group = info(type).group;
  return group == ActionClass::Movement || group == ActionClass::Reach;
}

bool only_looks(ActionType type) {
  return moves_the_body(type) || type == ActionType::Open || type == ActionType::Close;
}

/// How many steps do not only tidy up.
int steps_for_the_goal(const DemonstrationRecord& demonstration) {
  return static_cast<int>(std::count_if(demonstration.steps.begin(), demonstration.steps.end(),
                                        [](const StepRecord& step) { return !step.tidying; }));
}

/// Whether the commands after one that is left out reach the goal.
bool goes_without(const Formula& goal, InformedEpisode here, const TraceMaker& traces, const std::vector<Command>& plan,
                  std::size_t left_out) {
  for (std::size_t i = left_out + 1; i < plan.size(); ++i) (void)here.act(plan[i]);
  return holds(goal, traces.of(here.changes));
}

/// What is wrong with a plan for a goal that needs each step, done in an episode.
std::optional<std::string> fault_of(const Formula& goal, InformedEpisode& here, const TraceMaker& traces, Mode mode,
                                    const std::vector<Command>& plan) {
  for (std::size_t i = 0; i < plan.size(); ++i) {
    const auto step = "step " + std::to_string(i + 1) + " " + to_text(plan[i]);
    const auto type = action_named(plan[i].action);
    if (!type || !offers(info(*type), mode)) return "has " + step + ", which the mode does not offer";
    if (*type != ActionType::Stop && goes_without(goal, here, traces, plan, i))
      return "reaches the goal without " + step + " as well";
    if (!here.act(plan[i])) return "fails at " + step;
  }
  if (!here.episode.world().stopped()) return "does not end with stop()";
  if (!holds(goal, traces.of(here.changes))) return "does not reach the goal";
  return std::nullopt;
}

/// Those of M1, but that no plan as long as this is too long or fails too often.
ModeRules without_limits(const std::vector<Action>& plan) {
  ModeRules rules = rules_of(Mode::M1);
  rules.limits.steps = rules.limits.failures = static_cast<int>(plan.size()) + 1;
  return rules;
}

}  // namespace

std::vector<bool> search_steps(const Formula& goal, const World& start, const TraceMaker& traces,
                               const std::vector<Action>& plan) {
  std::vector<Command> commands;
  for (const Action& action : plan) commands.push_back(by_ids(action));
  std::vector<bool> search;
  InformedEpisode here{ModeEpisode(start, without_limits(plan)), {}};
  for (std::size_t i = 0; i < plan.size(); ++i) {
    search.push_back(only_looks(plan[i].type) && goes_without(goal, here, traces, commands, i));
    (void)here.act(commands[i]);
  }
  return search;
}

std::vector<bool> tidying_steps(const Formula& goal, const World& start, const TraceMaker& traces,
                                const std::vector<Action>& plan) {
  std::vector<bool> tidying(plan.size(), false);
  // Whether the goal is reached without a step and all that are left out already.
  const auto is_needless = [&](std::size_t step) {
    InformedEpisode rest{ModeEpisode(start, without_limits(plan)), {}};
    for (std::size_t i = 0; i < plan.size(); ++i)
      if (i != step && !tidying[i]) (void)rest.act(by_ids(plan[i]));
    return holds(goal, traces.of(rest.changes));
  };
  // Whether the step ends what a step before it began.
  const auto sets_back = [&](std::size_t step) {
    const bool closes = plan[step].type == ActionType::Close;
    if (!closes && plan[step].type != ActionType::TurnOff) return false;
    const Action began{closes ? ActionType::Open : ActionType::TurnOn, plan[step].args};
    const auto here = plan.begin() + static_cast<std::ptrdiff_t>(step);
    return std::find(plan.begin(), here, began) != here;
  };
  for (std::size_t i = 0; i < plan.size(); ++i) {
    if (!sets_back(i) || !is_needless(i)) continue;
    tidying[i] = true;
    for (std::size_t k = i; k > 0 && moves_the_body(plan[k - 1].type) && is_needless(k - 1); --k) tidying[k - 1] = true;
  }
  return tidying;
}

StepMarks marks_of(const Formula& goal, const World& start, Mode mode, const TraceMaker& traces,
                   const std::vector<Action>& plan) {
  StepMarks marks{std::vector<bool>(plan.size(), false), tidying_steps(goal, start, traces, plan)};
  if (mode == Mode::M1) return marks;
  marks.search = search_steps(goal, start, traces, plan);
  for (std::size_t i = 0; i < plan.size(); ++i) marks.search[i] = marks.search[i] && !marks.tidying[i];
  return marks;
}

std::vector<Problem> check_marks(const DemonstrationRecord& demonstration, const StepMarks& marks,
                                 const std::string& where) {
  for (std::size_t i = 0; i < demonstration.steps.size(); ++i) {
    const StepRecord& step = demonstration.steps[i];
    const bool search = marks.is_search(i), tidying = marks.is_tidying(i);
    const auto found = [&](ProblemKind kind, const char* fault) {
      return std::vector{
          problem_in(kind, where, "step " + std::to_string(i + 1) + " " + to_text(step.command) + " " + fault)};
    };
    if (step.tidying != tidying)
      return found(ProblemKind::TidyingMark,
                   tidying ? "only closes or turns off what was opened or turned on before, and is "
                             "not marked as tidying"
                           : "is marked as tidying, but does not only tidy up");
    if (step.search != search)
      return found(ProblemKind::SearchMark, search ? "only serves to see something, and is not marked as search"
                                                   : "is marked as search, but the goal needs it");
  }
  return {};
}

std::vector<Problem> check_shortest(const Formula& goal, const World& start, const TraceMaker& traces,
                                    const TaskRecord& task, Mode mode, const DemonstrationRecord& demonstration,
                                    const std::string& where) {
  const auto found = [&where](std::string message) {
    return std::vector{problem_in(ProblemKind::ShortestPlan, where, "its shortest plan " + std::move(message))};
  };
  const std::vector<Command>& plan = demonstration.shortest;
  if (mode == Mode::M1 && !plan.empty()) return found("is beside a demonstration in M1");
  const int needed = steps_for_the_goal(demonstration);
  const bool all_needed = needed == static_cast<int>(demonstration.steps.size());
  const int steps = mode != Mode::M1 ? static_cast<int>(plan.size()) : all_needed ? 0 : needed;
  for (const TaskRecord::Count& count : task.expert) {
    if (count.mode == mode && count.shortest != steps)
      return found("has " + std::to_string(steps) + " steps, its task says " + std::to_string(count.shortest));
  }
  if (mode == Mode::M1) return {};
  if (steps > needed) return found("is longer than the demonstration");
  InformedEpisode here{ModeEpisode(start, Mode::M1), {}};
  if (const auto fault = fault_of(goal, here, traces, mode, plan)) return found(*fault);
  return {};
}

std::vector<Problem> check_tempting(const Formula& goal, const World& start, const TraceMaker& traces, Mode mode,
                                    const DemonstrationRecord& demonstration, const Trace& shown,
                                    const std::string& where) {
  const auto found = [&where](std::string message) {
    return std::vector{problem_in(ProblemKind::TemptingPlan, where, "its tempting plan " + std::move(message))};
  };
  const std::vector<Command>& plan = demonstration.tempting;
  const auto readings = mode == Mode::M1 ? hasty_readings(goal) : std::vector<HastyReading>();
  if (plan.empty()) return readings.empty() ? std::vector<Problem>() : found("is missing");
  if (readings.empty()) return found("is beside a goal that has no constraint, or not in M1");
  if (static_cast<int>(plan.size()) > steps_for_the_goal(demonstration))
    return found("is longer than the demonstration");
  std::string fault = "takes the goal for nothing that anybody would";
  for (const HastyReading& reading : readings) {
    if (reading.takes_more && holds(reading.goal, shown)) continue;
    InformedEpisode here{ModeEpisode(start, Mode::M1), {}};
    const auto wrong = fault_of(reading.goal, here, traces, mode, plan);
    if (wrong || plan.size() == 1) {
      fault = wrong ? *wrong : "does nothing";
      continue;
    }
    return holds(goal, traces.of(here.changes)) ? found("breaks no constraint") : std::vector<Problem>();
  }
  return found(fault);
}

}  // namespace unietp
