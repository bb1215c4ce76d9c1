#pragma once

#include <optional>

#include "grounding/failure.h"
#include "logic/formula.h"
#include "logic/trace.h"
#include "scene/node_index.h"
#include "scene/scene.h"
#include "simulation/navigation.h"

namespace unietp {

/// Meters on foot between two points of the floor plan: from the free cell nearest to one to that nearest to the other,
/// and from there to the points. nullopt when there is no way, or when it leaves the floor of the room.
std::optional<double> on_foot(const NavigationGrid& grid, const Room& room, const Vec2& from, const Vec2& to);

/// What a goal calls the nearest to something is so on foot, too, by the margins of `nearest`, along a way within the
/// room of both: among the others of its category in that room. `grid`: of the scene; `trace`: its first state is read.
/// The first reference that is not so (`odd-reference`), or nullopt.
std::optional<GroundingFailure> check_nearness_on_foot(const Formula& goal, const Scene& scene, const NodeIndex& places,
                                                       const Trace& trace, const NavigationGrid& grid);

}  // namespace unietp
