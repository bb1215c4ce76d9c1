#include "scene/room_finder.h"

namespace unietp {

RoomFinder::RoomFinder(const std::vector<Room>& rooms) {
  for (const Room& room : rooms) {
    Extent extent{Vec2::Zero(), Vec2::Zero()};
    if (!room.polygon.empty()) extent = {room.polygon.front(), room.polygon.front()};
    for (const Vec2& corner : room.polygon) {
      extent.low = extent.low.cwiseMin(corner);
      extent.high = extent.high.cwiseMax(corner);
    }
    extents_.push_back(extent);
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
