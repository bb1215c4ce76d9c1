#pragma once

#include "scene/scene.h"

namespace unietp {

/// Whether the point is in a room or less than half a meter from one: what lies farther is not in the home.
bool is_near_a_room(const Scene& scene, const Vec2& point);

}  // namespace unietp
