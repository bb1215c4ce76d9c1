#pragma once

#include <string>
#include <variant>
#include <vector>

#include "akb/knowledge.h"
#include "expert/demonstration.h"
#include "expert/execution_tree.h"
#include "generator/rejection.h"
#include "logic/formula.h"
#include "simulation/profile.h"

namespace unietp {

/// Stage: works only from the goal formula: chooses witnesses, orders subgoals, expands them to actions, executes them
/// in the backend, replans on failure, stops. Knows no template. Kept only if the goal holds on the executed trace by
/// the direct evaluator. Deterministic.
std::variant<Demonstration, Rejection> demonstrate(ExecutionTree& executions, const ExpertOptions& options);
/// The same from a start of which nothing is known yet. Rejected as `no-plan`, too, when the start cannot be built.
std::variant<Demonstration, Rejection> demonstrate(const Formula& goal, const Scene& start, const Knowledge& knowledge,
                                                   const Profile& profile, const ExpertOptions& options);

/// Must-fail mutations, each under the rules of the demonstration's mode: every step dropped in turn, what was put down
/// carried to the end instead, the parts of an order swapped, a distractor in place of a referent. Gives those (as
/// text) after which the goal still holds: none when the goal really tests the plan. A step whose absence makes no
/// difference to the goal is among them, but for search and tidying.
std::vector<std::string> needless_steps(ExecutionTree& executions, const Demonstration& demonstration);
std::vector<std::string> needless_steps(const Formula& goal, const Scene& start, const Demonstration& demonstration,
                                        const Knowledge& knowledge, const Profile& profile);

}  // namespace unietp
