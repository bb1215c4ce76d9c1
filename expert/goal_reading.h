#pragma once

#include <vector>

#include "expert/estimate.h"
#include "expert/subgoal.h"
#include "logic/formula.h"

namespace unietp {

/// Limits of the choices that are looked at.
struct ReadingOptions {
  std::size_t beam = 24;           // alternatives kept wherever two choices meet
  std::size_t witnesses = 8;       // looked at for one `exists`, the nearest
  std::size_t assignments = 4000;  // tuples of witnesses looked at for nested `exists`
};

/// Turns a goal into ways to meet it, cheapest first: `exists` becomes a choice of witness, `forall` all members, `or`
/// and `imply` a choice of branch, `count` a choice of which to bring and which to remove, the temporal operators
/// moments with an order and truths to keep. Ways that contradict themselves, or need what nothing in the scene can do,
/// are left out, so an empty list means that no way was found. Sound with respect to the choice, not complete: the beam
/// is finite. Deterministic.
std::vector<Alternative> read_goal(const Formula& goal, const Situation& situation, const CostPenalties& experience,
                                   const ReadingOptions& options = {});

}  // namespace unietp
