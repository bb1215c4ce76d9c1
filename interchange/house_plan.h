#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace unietp {

/// A piece of a room's outline that has the same room, or none, behind it over its whole length.
struct WallPart {
  std::size_t room = 0;                         // position in Scene::rooms
  std::optional<std::size_t> behind;            // the room on the other side; none: outside
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();  // W, the room on the left of the way from one to the other
};

/// The outlines of all rooms cut where another room's corner lies on them, room by room, counter-clockwise.
std::vector<WallPart> wall_parts(const Scene& scene);

/// Where something on a wall is: along it from `from`, meters; nullopt when no part of a wall has it.
struct OnWall {
  std::size_t part = 0;  // position in the parts
  double along = 0;
};
/// The part nearest to a point, within `reach` meters of its line; `room` and `behind` as asked.
std::optional<OnWall> nearest_wall(const std::vector<WallPart>& parts, const Vec2& point, double reach,
                                   std::optional<std::size_t> room = std::nullopt,
                                   std::optional<std::size_t> behind = std::nullopt);

}  // namespace unietp
