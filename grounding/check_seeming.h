#pragma once

#include <optional>

#include "akb/knowledge.h"
#include "grounding/failure.h"
#include "logic/formula.h"
#include "logic/trace.h"

namespace unietp {

/// Whether what a goal asks for, forbids or tells things apart by would seem to be so at the start though it is not:
/// bread in a bowl on the counter is on the counter to who asks to put bread there. Things that are on or in something
/// movable that is at the place are at the place to people, and to the goal they are not. The first such pair of a
/// thing and a place that the goal relates by `on` or `inside`, or nullopt.
///
/// The same of things that are to be washed when some are clean already, and of clean things that are to go where such
/// things are washed: who asks to wash "every plate", or to put "a plate" in the dishwasher, means dirty ones. And of
/// what is to be put next to a thing in the sink, of dirty things that are to be taken out of it, and of what is to be
/// put on, in or next to a thing that is put away in a cabinet and stays there. `trace` has at least one state.
std::optional<GroundingFailure> check_seeming(const Formula& goal, const Trace& trace, const Knowledge& knowledge);

}  // namespace unietp
