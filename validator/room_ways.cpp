#include "validator/room_ways.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

#include "scene/geometry.h"

namespace unietp {

RoomWays::RoomWays(const NavigationGrid& grid, const CellSet& reached, const Room& room, const Vec2& from)
    : from_(from) {
  const Bounds around = room_bounds(room, 1);
  const auto low = grid.cell_at(around.low.head<2>()), high = grid.cell_at(around.high.head<2>());
  const int left = std::max(0, low.x), right = std::min(grid.width() - 1, high.x);
  const int front = std::max(0, low.y), back = std::min(grid.height() - 1, high.y);
  width_ = std::max(0, right - left + 1);
  height_ = std::max(0, back - front + 1);
  for (int y = front; y <= back; ++y) {
    for (int x = left; x <= right; ++x) {
      centers_.push_back(grid.center({x, y}));
      floor_.push_back(reached.has(x, y) && contains(room.polygon, centers_.back()));
    }
  }
  ways_.assign(floor_.size(), kNoWay);
  first_ = nearest(from);
  if (first_) walk(*first_);
}

std::optional<std::size_t> RoomWays::nearest(const Vec2& point) const {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < floor_.size(); ++i) {
    if (floor_[i] && (!best || (centers_[i] - point).squaredNorm() < (centers_[*best] - point).squaredNorm())) best = i;
  }
  return best;
}

/// Dijkstra's algorithm.
void RoomWays::walk(std::size_t first) {
  using Open = std::pair<double, std::size_t>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  ways_[first] = 0;
  open.emplace(0, first);
  while (!open.empty()) {
    const auto [way, i] = open.top();
    open.pop();
    if (way > ways_[i]) continue;
    const int x = static_cast<int>(i) % width_, y = static_cast<int>(i) / width_;
    const auto at = [&, x = x, y = y](int dx, int dy) -> std::optional<std::size_t> {
      if (x + dx < 0 || x + dx >= width_ || y + dy < 0 || y + dy >= height_) return std::nullopt;
      const int cell = (y + dy) * width_ + x + dx;
      const auto place = static_cast<std::size_t>(cell);
      return floor_[place] ? std::optional(place) : std::nullopt;
    };
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const auto next = at(dx, dy);
        if (!next || !at(dx, 0) || !at(0, dy)) continue;
        const double there = way + (dx != 0 && dy != 0 ? std::sqrt(2.0) : 1.0) * NavigationGrid::kCell_m;
        if (there >= ways_[*next]) continue;
        ways_[*next] = there;
        open.emplace(there, *next);
      }
    }
  }
}

std::optional<double> RoomWays::meters(const Vec2& to) const {
  const auto last = nearest(to);
  if (!first_ || !last || ways_[*last] == kNoWay) return std::nullopt;
  return (centers_[*first_] - from_).norm() + ways_[*last] + (centers_[*last] - to).norm();
}

}  // namespace unietp
