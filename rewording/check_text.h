#pragma once

#include <vector>

#include "resources/resources.h"
#include "validator/stated_goal.h"

namespace unietp {

/// The grammar's reading of a text, for the validator: its form; what it means, read back and proven to be the goal,
/// or, when a model wrote it, its words held against the goal (nothing of one that a person vouches for, unread); its
/// style; and the set of its turn of phrase. Pure; `backend` is that of the task's simulator.
std::vector<Problem> check_text(const StatedGoal& stated, const Backend& backend);

}  // namespace unietp
