#pragma once

#include <string>
#include <vector>

#include "logic/formula.h"
#include "logic/monitor.h"

namespace unietp {

/// What a part of a goal asks for.
enum class GoalPartKind : std::uint8_t {
  State,       // something to reach
  Count,       // a number of things
  Order,       // one thing before another
  Constraint,  // what must stay as it is
};
std::string_view name_of(GoalPartKind kind);  // "state"

/// A conjunct of a goal, with the quantifiers that bind its variables, so that it can be read by itself. Where two
/// parts share a variable, each may be met by another object: parts tell how far an agent came, the whole goal decides.
struct GoalPart {
  GoalPartKind kind = GoalPartKind::State;
  Formula formula;
};

/// The parts of a goal, in order of its text. Without "is another object"; each part once. At least one.
std::vector<GoalPart> goal_parts(const Formula& goal);

}  // namespace unietp
