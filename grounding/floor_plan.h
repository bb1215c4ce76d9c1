#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/rng.h"
#include "scene/scene.h"

namespace unietp {

inline constexpr double kOpeningWidth_m = 1.0;

struct FloorPlan {
  std::vector<Room> rooms;
  std::vector<Opening> openings;
};

/// Stage: room types → a rectangle cut into rectangular rooms, each within its type's usual size (9 to 30 m²), joined
/// by openings in shared walls so that all hang together: a spanning tree that prefers living rooms and corridors, and
/// some openings more. Rooms come in the order of `types`; ids are type_1, type_2, …. nullopt when this draw gives a
/// room that is too narrow or cannot be joined. Deterministic in rng.
std::optional<FloorPlan> draw_floor_plan(const std::vector<std::string>& types, Rng rng);

/// The rectangle of a room's polygon.
Bounds room_bounds(const Room& room, double height);

}  // namespace unietp
