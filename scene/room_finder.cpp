#include "scene/room_finder.h"

namespace unietp {

RoomFinder::RoomFinder(const std::vector<Room>& rooms) {
  for (const Room& room : rooms) {
    const Bounds bounds = room_bounds(room, 0);
    extents_.push_back({bounds.low.head<2>(), bounds.high.head<2>()});
    polygons_.push_back(room.polygon);
  }
}

std::optional<std::uint32_t> RoomFinder::at(const Vec2& point) const {
  for (std::size_t i = 0; i < extents_.size(); ++i) {
    const auto& [low, high] = extents_[i];
    const bool outside = point.x() < low.x() || point.x() > high.x() || point.y() < low.y() || point.y() > high.y();
    if (!outside && contains(polygons_[i], point)) return static_cast<std::uint32_t>(i);
  }
  return std::nullopt;
}

}  // namespace unietp
