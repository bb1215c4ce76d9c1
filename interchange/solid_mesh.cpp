#include "interchange/solid_mesh.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace unietp {
namespace {

/// A side of what stands in the solid's own frame: half widths at its lower and upper end, and their heights.
struct Side {
  Vec2 low = Vec2::Ones(), high = Vec2::Ones();
  double bottom = -1, top = 1;
  bool inward = false;  // seen from its axis
};

class Tessellation {
 public:
  Tessellation(GltfMesh& mesh, const Solid& solid, const Pose& to_file) : mesh_(mesh) {
    const Eigen::Matrix3d own =
        solid.sheared ? solid.axes
                      : Eigen::Matrix3d(solid.pose.rotation.toRotationMatrix() * (solid.size / 2).asDiagonal());
    axes_ = to_file.rotation.toRotationMatrix() * own;
    forms_ = axes_.inverse().transpose();
    center_ = to_file * solid.pose.position;
    mirrored_ = axes_.determinant() < 0;
  }

  void add_walls(const std::vector<Vec2>& outline, const Side& wall, bool smooth) {
    const std::size_t count = outline.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Vec2 &here = outline[i], &next = outline[(i + 1) % count];
      std::array<std::uint32_t, 4> corner{};
      for (std::size_t k = 0; k < 4; ++k) {
        const Vec2& at = k % 2 == 0 ? here : next;
        const bool above = k >= 2;
        const Vec2 along = smooth ? Vec2(-at.y(), at.x()) : Vec2(next - here);
        const Vec2& middle = smooth ? at : Vec2((here + next) / 2);
        corner[k] = add_point(wall, at, above, normal_of(wall, along, middle, above && smooth));
      }
      add_triangle(corner[0], corner[1], corner[3], wall.inward);
      add_triangle(corner[0], corner[3], corner[2], wall.inward);
    }
  }

  void add_cap(const std::vector<Vec2>& outline, const Vec2& wide, double z, bool up) {
    const auto first = static_cast<std::uint32_t>(mesh_.points.size());
    for (const Vec2& at : outline) {
      const Vec2 point = at.cwiseProduct(wide);
      add_point({point.x(), point.y(), z}, {0, 0, up ? 1.0 : -1.0});
    }
    for (std::uint32_t i = 1; i + 1 < outline.size(); ++i) add_triangle(first, first + i, first + i + 1, !up);
  }

  /// The flat ring between the upper ends of two walls.
  void add_rim(const std::vector<Vec2>& outline, const Vec2& inner, const Vec2& outer) {
    const auto first = static_cast<std::uint32_t>(mesh_.points.size());
    const auto count = static_cast<std::uint32_t>(outline.size());
    for (const Vec2& at : outline) {
      for (const Vec2& wide : {inner, outer}) add_point({at.x() * wide.x(), at.y() * wide.y(), 1}, Vec3::UnitZ());
    }
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t here = first + 2 * i, next = first + 2 * ((i + 1) % count);
      add_triangle(here, here + 1, next + 1, false);
      add_triangle(here, next + 1, next, false);
    }
  }

  void add_ball(const std::vector<Vec2>& outline) {
    const auto count = static_cast<std::uint32_t>(outline.size()), rings = count / 2;
    const auto first = static_cast<std::uint32_t>(mesh_.points.size());
    for (std::uint32_t ring = 0; ring <= rings; ++ring) {
      const double angle = std::numbers::pi * ring / rings;  // from the bottom up
      for (const Vec2& at : outline) {
        const Vec3 point(std::sin(angle) * at.x(), std::sin(angle) * at.y(), -std::cos(angle));
        add_point(point, point);
      }
    }
    for (std::uint32_t ring = 0; ring < rings; ++ring) {
      for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t low = first + ring * count, high = low + count, next = (i + 1) % count;
        if (ring > 0) add_triangle(low + i, low + next, high + next, false);
        if (ring + 1 < rings) add_triangle(low + i, high + next, high + i, false);
      }
    }
  }

 private:
  /// Of a wall, outward, at one of its ends; where that end is a point or an edge, halfway to the other.
  static Vec3 normal_of(const Side& wall, const Vec2& along, const Vec2& at, bool above) {
    const Vec2& end = above ? wall.high : wall.low;
    const Vec2 wide = end.minCoeff() > 0 ? end : Vec2((wall.low + wall.high) / 2);
    const Vec2 around = along.cwiseProduct(wide),
               upward = at.cwiseProduct(wall.high - wall.low) / (wall.top - wall.bottom);
    return Vec3(around.x(), around.y(), 0).cross(Vec3(upward.x(), upward.y(), 1));
  }

  std::uint32_t add_point(const Side& wall, const Vec2& at, bool above, const Vec3& normal) {
    const Vec2 point = at.cwiseProduct(above ? wall.high : wall.low);
    return add_point({point.x(), point.y(), above ? wall.top : wall.bottom}, wall.inward ? Vec3(-normal) : normal);
  }

  std::uint32_t add_point(const Vec3& own, const Vec3& normal) {
    mesh_.points.push_back(axes_ * own + center_);
    mesh_.normals.push_back((forms_ * normal).normalized());
    return static_cast<std::uint32_t>(mesh_.points.size() - 1);
  }

  /// Counter-clockwise from outside in the solid's own frame, or clockwise. Those without area are left out.
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool clockwise) {
    const Vec3 &at = mesh_.points[a], &second = mesh_.points[b], &third = mesh_.points[c];
    if (at == second || second == third || third == at) return;
    if (clockwise != mirrored_) std::swap(b, c);
    mesh_.corners.insert(mesh_.corners.end(), {a, b, c});
  }

  GltfMesh& mesh_;
  Eigen::Matrix3d axes_, forms_;
  Vec3 center_;
  bool mirrored_ = false;
};

std::vector<Vec2> circle(std::uint32_t sides) {
  std::vector<Vec2> outline;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    outline.emplace_back(std::cos(angle), std::sin(angle));
  }
  return outline;
}

}  // namespace

std::size_t triangles_of(const Solid& solid, std::uint32_t sides) {
  switch (solid.kind) {
    case SolidKind::Box:
    case SolidKind::Wedge:
      return 12;
    case SolidKind::Crate:
      return 28;
    case SolidKind::Cylinder:
    case SolidKind::Cone:
      return 4 * sides - 4;
    case SolidKind::Cup:
      return 8 * sides - 4;
    case SolidKind::Sphere:
      break;
  }
  return std::size_t{sides} * (sides - 2);
}

void add_surface(GltfMesh& mesh, const Solid& solid, std::uint32_t sides, const Pose& to_file) {
  Tessellation surface(mesh, solid, to_file);
  if (solid.kind == SolidKind::Sphere) return surface.add_ball(circle(sides));
  const bool hollow = solid.kind == SolidKind::Cup || solid.kind == SolidKind::Crate;
  const bool round = solid.kind == SolidKind::Cup || solid.kind == SolidKind::Cylinder || solid.kind == SolidKind::Cone;
  const std::vector<Vec2> outline = round ? circle(sides) : std::vector<Vec2>{{1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
  const Side outer{solid.low, solid.high};
  surface.add_walls(outline, outer, round);
  surface.add_cap(outline, outer.low, -1, false);
  if (!hollow) return surface.add_cap(outline, outer.high, 1, true);
  const Vec2 wall = Vec2::Constant(solid.wall);
  const Side inner{solid.low + (solid.high - solid.low) * solid.floor / 2 - wall, solid.high - wall, solid.floor - 1, 1,
                   true};
  surface.add_walls(outline, inner, round);
  surface.add_cap(outline, inner.low, inner.bottom, true);
  surface.add_rim(outline, inner.high, outer.high);
}

}  // namespace unietp
