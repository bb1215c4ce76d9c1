#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "expert/demonstration.h"
#include "expert/execution_tree.h"
#include "generator/rejection.h"
#include "simulation/mode_rules.h"

namespace unietp {

/// The first plan that works, without looking: its actions, of which none can be missed, ending with `stop`.
std::variant<std::vector<Action>, Rejection> find_plan(ExecutionTree& executions, const ExpertOptions& options);

/// What was done and learned before a plan failed.
struct ExecutedPrefix {
  std::vector<Action> done;          // from the start; all of them have to succeed, else there is no plan
  std::vector<std::string> avoided;  // ids of objects that could not be reached: others are used where possible
  bool clears = false;               // also carries out of the way what only may be in it
};
/// How to go on from there: the actions after those that were done, ending with `stop`; some may not be needed.
std::variant<std::vector<Action>, Rejection> find_plan_from(ExecutionTree& executions, const ExecutedPrefix& beginning,
                                                            const ExpertOptions& options);

/// The same, compared with other choices as those of a demonstration are: the one that takes least (plan_cost.h).
std::variant<std::vector<Action>, Rejection> find_cheapest_plan_from(ExecutionTree& executions,
                                                                     const ExecutedPrefix& beginning,
                                                                     const ExpertOptions& options);

/// Moves the body or camera, or goes or turns to something, and changes nothing else.
bool only_leads_somewhere(const Action& action);

/// Does the actions from the start as an agent of the mode would live them; what it cannot say is left out.
Demonstration record(ExecutionTree& executions, Mode mode, const std::vector<Action>& actions);

/// Leaves out steps until none can be missed: single ones, then runs of up to `longest_run` (a thing picked up and put
/// back), then putting a thing down that might as well stay in the hand; whatever fails for want of them goes too.
/// `actions` ends with `stop`, which stays, as do the first `done`. nullopt when the goal does not hold after all of
/// them.
std::optional<std::vector<Action>> without_needless(ExecutionTree& executions, const ModeRules& rules,
                                                    std::vector<Action> actions, std::size_t longest_run,
                                                    std::size_t done = 0);

/// A plan in which something that was put down is carried to the end: all that was done to it while it was in the hand
/// comes last.
struct LeftInHand {
  std::string thing;
  std::vector<Action> actions;
};
/// One for every action that puts something down. Things whose way to the hand the actions do not show are passed over.
std::vector<LeftInHand> left_in_hand(const std::vector<Action>& actions);

}  // namespace unietp
