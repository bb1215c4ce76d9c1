#include "validator/room_ways.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/geometry.h"

namespace unietp {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

}  // namespace

RoomWays::RoomWays(const NavigationGrid& grid, const CellSet& reached, const Room& room)
    : width_(grid.width()), height_(grid.height()) {
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      centres_.push_back(grid.centre({x, y}));
      floor_.push_back(reached.has(x, y) && contains(room.polygon, centres_.back()));
    }
  }
}

std::optional<std::size_t> RoomWays::nearest(const Vec2& point) const {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < floor_.size(); ++i) {
    if (floor_[i] && (!best || (centres_[i] - point).squaredNorm() < (centres_[*best] - point).squaredNorm())) best = i;
  }
  return best;
}

/// The shortest way to a cell that comes from one of its neighbors.
double RoomWays::through(const std::vector<double>& ways, std::size_t i) const {
  const int x = static_cast<int>(i) % width_, y = static_cast<int>(i) / width_;
  const auto at = [&](int dx, int dy) -> std::optional<std::size_t> {
    if (x + dx < 0 || x + dx >= width_ || y + dy < 0 || y + dy >= height_) return std::nullopt;
    const auto place = static_cast<std::size_t>((y + dy) * width_ + x + dx);
    return floor_[place] ? std::optional(place) : std::nullopt;
  };
  double best = kNone;
  for (const int side : {-1, 1}) {
    if (const auto beside = at(side, 0)) best = std::min(best, ways[*beside] + NavigationGrid::kCell_m);
    if (const auto beside = at(0, side)) best = std::min(best, ways[*beside] + NavigationGrid::kCell_m);
    for (const int other : {-1, 1}) {
      const auto corner = at(side, other);
      if (corner && at(side, 0) && at(0, other))
        best = std::min(best, ways[*corner] + std::sqrt(2.0) * NavigationGrid::kCell_m);
    }
  }
  return best;
}

void RoomWays::sweep(std::vector<double>& ways, bool forward, bool& changed) const {
  for (std::size_t k = 0; k < ways.size(); ++k) {
    const std::size_t i = forward ? k : ways.size() - 1 - k;
    if (!floor_[i]) continue;
    const double way = through(ways, i);
    if (way >= ways[i]) continue;
    ways[i] = way;
    changed = true;
  }
}

std::optional<double> RoomWays::meters(const Vec2& from, const Vec2& to) const {
  const auto first = nearest(from), last = nearest(to);
  if (!first || !last) return std::nullopt;
  std::vector<double> ways(floor_.size(), kNone);
  ways[*first] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    sweep(ways, true, changed);
    sweep(ways, false, changed);
  }
  if (ways[*last] == kNone) return std::nullopt;
  return (centres_[*first] - from).norm() + ways[*last] + (centres_[*last] - to).norm();
}

}  // namespace unietp
