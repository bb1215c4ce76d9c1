#include "simulation/walls.h"

#include <algorithm>
#include <cmath>

namespace unietp {
namespace {

constexpr double kOnLine_m = 0.02;

struct Interval {
  double from, to;
  double low_z;  // height of the gap; the wall continues above
};

WallPiece wall_piece(const Vec2& start, const Vec2& along, double from, double to, double low_z, double high_z,
                     double thickness) {
  const Vec2 middle = start + along * ((from + to) / 2);
  const double yaw = std::atan2(along.y(), along.x());
  return {upright(Vec3(middle.x(), middle.y(), (low_z + high_z) / 2), yaw), Vec3(to - from, thickness, high_z - low_z)};
}

/// Openings near a room, in order.
std::vector<const Opening*> openings_by(const Room& room, const Scene& scene) {
  Vec2 low = room.polygon.empty() ? Vec2(0, 0) : room.polygon.front(), high = low;
  for (const Vec2& corner : room.polygon) low = low.cwiseMin(corner), high = high.cwiseMax(corner);
  low.array() -= kOnLine_m, high.array() += kOnLine_m;
  std::vector<const Opening*> near;
  for (const Opening& opening : scene.openings) {
    const Vec2 from = opening.from.cwiseMin(opening.to), to = opening.from.cwiseMax(opening.to);
    if ((from.array() <= high.array()).all() && (to.array() >= low.array()).all()) near.push_back(&opening);
  }
  return near;
}

}  // namespace

std::vector<WallPiece> walls_of(const Scene& scene) {
  constexpr double kShortest_m = 0.01;
  std::vector<WallPiece> pieces;
  for (const Room& room : scene.rooms) {
    const std::vector<const Opening*> openings = openings_by(room, scene);
    for (std::size_t i = 0; i < room.polygon.size(); ++i) {
      const Vec2 start = room.polygon[i], end = room.polygon[(i + 1) % room.polygon.size()];
      const double length = (end - start).norm();
      if (length < kShortest_m) continue;
      const Vec2 along = (end - start) / length, across(-along.y(), along.x());
      std::vector<Interval> gaps;
      for (const Opening* one : openings) {
        const Opening& opening = *one;
        if (std::abs((opening.from - start).dot(across)) > kOnLine_m) continue;
        if (std::abs((opening.to - start).dot(across)) > kOnLine_m) continue;
        double a = (opening.from - start).dot(along), b = (opening.to - start).dot(along);
        if (a > b) std::swap(a, b);
        a = std::max(a, 0.0);
        b = std::min(b, length);
        if (b - a > kShortest_m) gaps.push_back({a, b, opening.height});
      }
      std::sort(gaps.begin(), gaps.end(), [](const Interval& x, const Interval& y) { return x.from < y.from; });
      const auto add = [&](double from, double to, double low_z) {
        pieces.push_back(wall_piece(start, along, from, to, low_z, scene.wall_height, scene.wall_thickness));
      };
      double at = 0;
      for (const Interval& gap : gaps) {
        if (gap.from - at > kShortest_m) add(at, gap.from, 0);
        if (scene.wall_height - gap.low_z > kShortest_m) add(gap.from, gap.to, gap.low_z);
        at = std::max(at, gap.to);
      }
      if (length - at > kShortest_m) add(at, length, 0);
    }
  }
  return pieces;
}

}  // namespace unietp
