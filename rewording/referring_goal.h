#pragma once

#include <optional>

#include "core/rng.h"
#include "logic/formula.h"
#include "scene/scene.h"
#include "scene/trace.h"

namespace unietp {

/// The goal of an episode said of the very object that its demonstration used: one variable gets a `:where` ("the dirty
/// mug", "the mug on the desk") that in this start picks out one of several, and the goal still holds on the trace of
/// the demonstration. nullopt when nothing simple tells an object apart. Deterministic in rng.
std::optional<Formula> referring_goal(const Formula& goal, const Scene& start, const Trace& trace, Rng rng);

}  // namespace unietp
