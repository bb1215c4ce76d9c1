#include "scene/room_finder.h"

#include <algorithm>
#include <limits>

namespace unietp {

RoomFinder::RoomFinder(const std::vector<Room>& rooms) {
  double high = -std::numeric_limits<double>::infinity();
  low_ = -high;
  for (const Room& room : rooms) {
    const Bounds bounds = room_bounds(room, 0);
    extents_.push_back({bounds.low.head<2>(), bounds.high.head<2>()});
    polygons_.push_back(room.polygon);
    low_ = std::min(low_, bounds.low.x());
    high = std::max(high, bounds.high.x());
  }
  if (rooms.empty()) return;
  strips_.resize(rooms.size());
  if (high > low_) strip_m_ = (high - low_) / static_cast<double>(rooms.size());
  for (std::size_t i = 0; i < extents_.size(); ++i) {
    for (std::size_t k = strip(extents_[i].low.x()); k <= strip(extents_[i].high.x()); ++k)
      strips_[k].push_back(static_cast<std::uint32_t>(i));
  }
}

/// Strip of an x coordinate; points left or right of all rooms count to the first or the last. Never decreases with x.
std::size_t RoomFinder::strip(double x) const {
  const double at = (x - low_) / strip_m_, last = static_cast<double>(strips_.size() - 1);
  return at > 0 ? static_cast<std::size_t>(std::min(at, last)) : 0;
}

std::optional<std::uint32_t> RoomFinder::at(const Vec2& point) const {
  if (strips_.empty()) return std::nullopt;
  for (const std::uint32_t i : strips_[strip(point.x())]) {
    const auto& [low, high] = extents_[i];
    const bool outside = point.x() < low.x() || point.x() > high.x() || point.y() < low.y() || point.y() > high.y();
    if (!outside && contains(polygons_[i], point)) return i;
  }
  return std::nullopt;
}

}  // namespace unietp
