#pragma once

#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "generator/rejection.h"
#include "logic/formula.h"
#include "logic/trace.h"

namespace unietp {

/// The first start constraint that a home does not meet and no edit of a start would: the number of its rooms and of
/// its furniture, and where its furniture stands. Furniture is neither taken out nor set up beside some that is there
/// already, since such a home would look like no other; only what the home lacks altogether may be set up where it
/// usually stands. nullptr when there is none. `now`: the home's state, with comparisons where constraints compare.
const Formula* misfit(const std::vector<Formula>& init, const Knowledge& knowledge, const Trace& now);

/// What a home without such a thing lacks: furniture, a room, or, for a name that is neither a category nor could be a
/// type of room (these are in lower case), something unknown.
RejectionReason lack_of(const std::string& name, const Knowledge& knowledge);

}  // namespace unietp
