#pragma once

#include <optional>
#include <vector>

#include "scene/geometry.h"

namespace unietp {

/// Which way a thing faces when its file only has a box along the axes of W.
struct Facing {
  double yaw = 0;            // a multiple of a quarter turn
  Vec3 size = Vec3::Zero();  // the box's extents in the object frame
};

/// The quarter turn that fits best: the longer side lies as in `typical` (the model's or category's size; zero: not
/// known, and nearly square ones do not say), and of the turns that are left, the one whose back is nearest to a wall
/// of `room` when the thing stands `against_walls` (the front of furniture is where one reaches it from). The box in W
/// is the same for every answer. `extents` along W's axes; `room` may be empty.
Facing facing_of_box(const Vec3& center, const Vec3& extents, const Vec3& typical, bool against_walls,
                     const std::vector<Vec2>& room);

/// Full extents in the object frame of a box whose bounds in W have `extents`, turned by `rotation`; nothing where the
/// turn does not let them be told (near 45°).
std::optional<Vec3> size_from_bounds(const Vec3& extents, const Quat& rotation);

}  // namespace unietp
