#include "scene/near_room.h"

#include <algorithm>

namespace unietp {

bool is_near_a_room(const Scene& scene, const Vec2& point) {
  constexpr double kNear_m = 0.5;
  const auto near = [&](const Vec2& start, const Vec2& end) {
    const Vec2 along = end - start;
    const double length = along.squaredNorm();
    const double t = length > 0 ? std::clamp((point - start).dot(along) / length, 0.0, 1.0) : 0.0;
    return (point - start - t * along).norm() < kNear_m;
  };
  return std::any_of(scene.rooms.begin(), scene.rooms.end(), [&](const Room& room) {
    if (contains(room.polygon, point)) return true;
    for (std::size_t i = 0; i < room.polygon.size(); ++i) {
      if (near(room.polygon[i], room.polygon[(i + 1) % room.polygon.size()])) return true;
    }
    return false;
  });
}

}  // namespace unietp
