#include "validator/search_check.h"

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
    const auto before = episode.world().moment();
    const bool done = episode.step(command).success;
    if (episode.world().moment() != before) changes.push_back(episode.world().changes());
    return done;
  }
};

bool only_looks(ActionType type) {
  const ActionClass group = info(type).group;
  return group == ActionClass::Movement || group == ActionClass::Reach || type == ActionType::Open ||
         type == ActionType::Close;
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

}  // namespace

std::vector<bool> search_steps(const Formula& goal, const World& start, const TraceMaker& traces,
                               const std::vector<Action>& plan) {
  std::vector<Command> commands;
  for (const Action& action : plan) commands.push_back(by_ids(action));
  std::vector<bool> search;
  ModeRules told = rules_of(Mode::M1);
  told.limits.steps = static_cast<int>(plan.size()) + 1;
  InformedEpisode here{ModeEpisode(start, told), {}};
  for (std::size_t i = 0; i < plan.size(); ++i) {
    search.push_back(only_looks(plan[i].type) && goes_without(goal, here, traces, commands, i));
    (void)here.act(commands[i]);
  }
  return search;
}

std::vector<Problem> check_marks(const DemonstrationRecord& demonstration, const std::vector<bool>& search,
                                 const std::string& where) {
  for (std::size_t i = 0; i < demonstration.steps.size(); ++i) {
    const bool should = i < search.size() && search[i];
    if (demonstration.steps[i].search == should) continue;
    return {problem_in(ProblemKind::SearchMark, where,
                       "step " + std::to_string(i + 1) + " " + to_text(demonstration.steps[i].command) +
                           (should ? " only serves to see something, and is not marked as search"
                                   : " is marked as search, but the goal needs it"))};
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
  if (mode == Mode::M1) return plan.empty() ? std::vector<Problem>() : found("is beside a demonstration in M1");
  const auto steps = static_cast<int>(plan.size());
  for (const TaskRecord::Count& count : task.expert) {
    if (count.mode == mode && count.shortest != steps)
      return found("has " + std::to_string(steps) + " steps, its task says " + std::to_string(count.shortest));
  }
  if (plan.size() > demonstration.steps.size()) return found("is longer than the demonstration");
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
  const bool wanted = mode == Mode::M1 && constrains_the_way(goal);
  if (plan.empty()) return wanted ? found("is missing") : std::vector<Problem>();
  if (!wanted) return found("is beside a goal that has no constraint, or not in M1");
  Formula asked = without_constraints(goal);
  if (plan.size() > demonstration.steps.size()) {
    asked = without_references(asked);
    if (holds(asked, shown)) return found("is longer than the demonstration");
  }
  InformedEpisode here{ModeEpisode(start, Mode::M1), {}};
  if (const auto fault = fault_of(asked, here, traces, mode, plan)) return found(*fault);
  if (holds(goal, traces.of(here.changes))) return found("breaks no constraint");
  return {};
}

}  // namespace unietp
