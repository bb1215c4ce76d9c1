#pragma once

#include <optional>

#include "generator/specification.h"
#include "grounding/failure.h"
#include "logic/trace.h"

namespace unietp {

/// Whether people in this home would tell the things that a goal means apart as its references do. They name one place
/// by another only where the home has one of those ("on the desk", not "on one of the desks"); what something is next
/// or nearest to is in the same room; the nearest, the largest, and the one that is not on the desk are told from
/// others in the same room, and the nearest from others in sight, not in closed containers, and not by what it is on
/// or in. What holds is read from the first state of the trace. The first reference that nobody would use, or nullopt.
std::optional<GroundingFailure> check_references(const Specification& specification, const Trace& trace);

}  // namespace unietp
