#include "interchange/box_facing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/LU>

namespace unietp {
namespace {

constexpr double kClearlyLonger = 1.12;  // ratio of sides from which one of them is the longer one

/// 1: x is clearly the longer side, -1: y is, 0: neither.
int longer_side(double x, double y) { return x > y * kClearlyLonger ? 1 : y > x * kClearlyLonger ? -1 : 0; }

/// Way from the point along a unit direction to the polygon's border; infinity when there is none ahead.
double way_to_border(const std::vector<Vec2>& polygon, const Vec2& from, const Vec2& along) {
  const auto cross = [](const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); };
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2 edge = polygon[i] - polygon[j], to_edge = polygon[j] - from;
    const double slope = cross(along, edge);
    if (std::abs(slope) < 1e-12) continue;
    const double way = cross(to_edge, edge) / slope, part = cross(to_edge, along) / slope;
    if (way >= 0 && part >= 0 && part <= 1) nearest = std::min(nearest, way);
  }
  return nearest;
}

}  // namespace

Facing facing_of_box(const Vec3& center, const Vec3& extents, const Vec3& typical, bool against_walls,
                     const std::vector<Vec2>& room) {
  const int lies = longer_side(extents.x(), extents.y()), should = longer_side(typical.x(), typical.y());
  Facing best;
  double least = std::numeric_limits<double>::infinity();
  for (const int quarter : {0, 2, 1, 3}) {
    const bool turned = quarter % 2 != 0;
    if (lies * should != 0 && turned != (lies != should)) continue;
    const Vec2 back = quarter == 0 ? Vec2(0, 1) : quarter == 1 ? Vec2(-1, 0) : quarter == 2 ? Vec2(0, -1) : Vec2(1, 0);
    const double gap =
        against_walls ? way_to_border(room, center.head<2>(), back) - extents[turned ? 0 : 1] / 2 : quarter;
    const bool first = best.size.isZero();
    if (!first && !(gap < least - 1e-3)) continue;  // of equal ones the first
    least = std::min(least, gap);
    best.yaw = quarter == 3 ? -std::numbers::pi / 2 : quarter * std::numbers::pi / 2;
    best.size = turned ? Vec3(extents.y(), extents.x(), extents.z()) : extents;
  }
  return best;
}

std::optional<Vec3> size_from_bounds(const Vec3& extents, const Quat& rotation) {
  constexpr double kTellsApart = 0.05;
  const Eigen::Matrix3d reach = rotation.toRotationMatrix().cwiseAbs();
  const Eigen::FullPivLU<Eigen::Matrix3d> solver(reach);
  if (std::abs(reach.determinant()) < kTellsApart || !solver.isInvertible()) return std::nullopt;
  const Vec3 size = solver.solve(extents);
  if (!size.allFinite() || !(size.minCoeff() > 0)) return std::nullopt;
  return size;
}

}  // namespace unietp
