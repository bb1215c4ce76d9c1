#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "logic/formula.h"
#include "scene/command.h"
#include "simulation/mode_rules.h"
#include "simulation/world.h"
#include "validator/problem.h"
#include "validator/search_check.h"
#include "validator/trace_maker.h"

namespace unietp {

/// How a plan was changed: without one of its steps, which put nothing down; without a step that put the held object
/// down; with two neighboring parts in the other order; with all parts in reverse; with an object that the goal
/// excludes in place of a referent; another plan, which forgets a constraint.
enum class PlanChange : std::uint8_t { MissingStep, KeptInHand, SwappedParts, ReversedParts, Distractor, Tempting };
std::string_view name_of(PlanChange change);  // "missing-step"

/// A changed plan as an agent says it, `stop` included, and what it came to.
struct AlteredPlan {
  PlanChange change = PlanChange::MissingStep;
  std::vector<Command> commands;
  bool reaches_goal = false;
  /// It reaches the goal but for its constraints; a tempting plan, some hasty reading of it (logic/constraints.h).
  bool breaks_constraint = false;
};

/// Result of running plans that must not reach the goal.
struct MustFail {
  std::vector<AlteredPlan> plans;  // in the order in which they were run
  std::vector<Problem> problems;
};

/// Changes the plan of a demonstration and runs each changed plan under the rules of its mode: without one of its steps
/// (an object that is then not put down stays in the hand), with its parts in a different order if the goal requires an
/// order, and with an excluded object in place of each referent. Actions whose object cannot be named at that point are
/// skipped. A changed plan that reaches the goal is a problem; of the orders, one that fails is enough, since not every
/// order matters, and no further one is tried. `plan`: the actions of the demonstration, with objects by their ids,
/// without `stop`; `marks`: which of them only served to see something or to tidy up, and so may be missing; the
/// changes of order and objects are made to the plan without those that tidy up.
MustFail must_fail(const Formula& goal, const World& start, Mode mode, const TraceMaker& traces,
                   const std::vector<Action>& plan, const StepMarks& marks, const std::string& where);

/// The tempting plan of a demonstration in M1, under the rules of a mode; nullopt where one of its actions cannot be
/// said or fails there.
std::optional<AlteredPlan> run_tempting(const Formula& goal, const World& start, Mode mode, const TraceMaker& traces,
                                        const std::vector<Command>& tempting);

}  // namespace unietp
