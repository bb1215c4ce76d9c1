#pragma once

#include <string>
#include <vector>

#include "logic/formula.h"
#include "record/task_record.h"
#include "simulation/world.h"
#include "validator/problem.h"
#include "validator/trace_maker.h"

namespace unietp {

/// Which steps of a plan only served to see something: those that move the body or camera, go or turn to something,
/// open or close, and without which alone the rest reaches the goal as well if objects may be named by id whether they
/// were seen or not. `plan`: actions on ids, without `stop`.
std::vector<bool> search_steps(const Formula& goal, const World& start, const TraceMaker& traces,
                               const std::vector<Action>& plan);

/// Which steps of a plan only tidy up: each `close` of what the plan opened before and `turn_off` of what it turned on,
/// and the steps right before it that only lead there, if the goal is reached without it and without all that were
/// found before. `plan`: as above.
std::vector<bool> tidying_steps(const Formula& goal, const World& start, const TraceMaker& traces,
                                const std::vector<Action>& plan);

/// Which steps of a demonstration the goal does not need. None has both marks; steps after the end of a list have none.
struct StepMarks {
  std::vector<bool> search, tidying;
  /// Of a step, counted from 0.
  bool is_search(std::size_t step) const { return step < search.size() && search[step]; }
  /// As is_search.
  bool is_tidying(std::size_t step) const { return step < tidying.size() && tidying[step]; }
};
/// Of a plan in a mode, in which only M2 and M3 have search.
StepMarks marks_of(const Formula& goal, const World& start, Mode mode, const TraceMaker& traces,
                   const std::vector<Action>& plan);
/// The marks of a demonstration against those.
std::vector<Problem> check_marks(const DemonstrationRecord& demonstration, const StepMarks& marks,
                                 const std::string& where);

/// The shortest plan beside a demonstration: it has the length that the task says, no more steps than the demonstration
/// and only actions of the mode; done by who is told everything, each step succeeds and is needed, and it reaches the
/// goal. In M1 there is none; the task says how many steps do not tidy up where some do.
std::vector<Problem> check_shortest(const Formula& goal, const World& start, const TraceMaker& traces,
                                    const TaskRecord& task, Mode mode, const DemonstrationRecord& demonstration,
                                    const std::string& where);

/// The tempting plan beside a demonstration in M1: it is there if the goal has constraints (logic/constraints.h) and
/// only then, and has no more steps than the demonstration without those that only tidy up; each step succeeds and is
/// needed, and it reaches one of the hasty readings of the goal, but not the goal. `shown`: the trace of the
/// demonstration.
std::vector<Problem> check_tempting(const Formula& goal, const World& start, const TraceMaker& traces, Mode mode,
                                    const DemonstrationRecord& demonstration, const Trace& shown,
                                    const std::string& where);

}  // namespace unietp
