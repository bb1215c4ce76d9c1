#pragma once

#include <vector>

#include "logic/formula.h"

namespace unietp {

/// The parts of a goal that the agent has to bring about, each a goal of its own with the quantifiers that bind its
/// variables: `(exists (?a - A) (at-end (and (clean ?a) (held ?a))))` has two. A proper start makes every one of them
/// false, not only the whole goal. Left out is what the agent only has to keep or may not break: `always`, that two
/// variables differ, empty hands. What must be undone and then restored, `(and (sometime (open ?a)) (at-end (closed
/// ?a)))`, is one part, because its second half alone is true from the start.
std::vector<Formula> goal_parts(const Formula& goal);

/// Two atoms that can never hold together: states of one exclusive group of the same object.
bool exclude_each_other(const Formula& first, const Formula& second);

}  // namespace unietp
