#pragma once

#include <optional>

#include "akb/knowledge.h"
#include "generator/specification.h"
#include "grounding/failure.h"
#include "grounding/reach.h"
#include "logic/trace.h"
#include "scene/node_index.h"

namespace unietp {

/// The geometric gates of a goal: whether each truth that it needs could come about in the start if it were the only
/// one, by geometry alone. What is to be put somewhere needs a spot there (Reach::spot_for), a door one that swings, a
/// change by an appliance a spot in one of those that the home has. Nothing is done and nothing is planned, so what
/// passes may still be impossible; what is refused nobody could do. With `pictured`, what can be carried has to show
/// clearly, too (Reach::shows). `places`: of the start's nodes; `trace`: the start in the
/// logic.
std::optional<GroundingFailure> check_goal(const Specification& specification, const Scene& start,
                                           const NodeIndex& places, const Trace& trace, const Knowledge& knowledge,
                                           const Profile& profile, Reach& reach, bool pictured);

}  // namespace unietp
