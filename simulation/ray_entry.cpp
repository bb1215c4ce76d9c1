#include "simulation/ray_entry.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace unietp {
namespace {

RayEntry enter_box(const Vec3& from, const Vec3& way, const Vec3& half) {
  double in = -kNever, out = kNever;
  int side = -1;
  for (int i = 0; i < 3; ++i) {
    if (way[i] == 0) {
      if (std::abs(from[i]) > half[i]) return {};
      continue;
    }
    const double across = 1 / way[i], middle = -from[i] * across, reach = half[i] * std::abs(across);
    if (middle - reach > in) {
      in = middle - reach;
      side = i;
    }
    out = std::min(out, middle + reach);
  }
  if (side < 0 || in > out || in <= 0) return {};
  RayEntry entry{in, Vec3::Zero()};
  entry.normal[side] = way[side] > 0 ? -1 : 1;
  return entry;
}

RayEntry enter_ball(const Vec3& from, const Vec3& way, double radius) {
  const double a = way.squaredNorm(), b = from.dot(way), c = from.squaredNorm() - radius * radius;
  const double root = b * b - a * c;
  if (root < 0 || c <= 0) return {};
  const double in = (-b - std::sqrt(root)) / a;
  if (in <= 0) return {};
  return {in, (from + in * way) / radius};
}

/// Cylinders stand along z.
RayEntry enter_cylinder(const Vec3& from, const Vec3& way, const Vec3& half) {
  const double radius = half.x();
  RayEntry entry;
  const double a = way.head<2>().squaredNorm(), b = from.head<2>().dot(way.head<2>());
  const double c = from.head<2>().squaredNorm() - radius * radius;
  const double root = b * b - a * c;
  if (a > 0 && root >= 0 && c > 0) {
    const double in = (-b - std::sqrt(root)) / a;
    const Vec3 at = from + in * way;
    if (in > 0 && std::abs(at.z()) <= half.z()) entry = {in, Vec3(at.x() / radius, at.y() / radius, 0)};
  }
  if (way.z() != 0) {
    const double top = way.z() > 0 ? -1 : 1, in = (top * half.z() - from.z()) / way.z();
    const Vec3 at = from + in * way;
    if (in > 0 && in < entry.along && at.head<2>().squaredNorm() <= radius * radius) entry = {in, Vec3(0, 0, top)};
  }
  return entry;
}

/// The half space n . p <= reach.
struct HalfSpace {
  Vec3 n;
  double reach = 0;
};

/// The part of a ray in a convex solid, and the faces through which it comes and goes (-1: none).
struct Crossing {
  double in = -kNever, out = kNever;
  int in_face = -1, out_face = -1;
  bool meets() const { return in <= out; }
};

/// The four sides of a block, then its bottom and top.
std::array<HalfSpace, 6> faces_of(const Vec2& low, const Vec2& high, double bottom, double top) {
  // Half width low + (high - low) (z - bottom) / (top - bottom).
  const Vec2 slope = (high - low) / (top - bottom), middle = low - slope * bottom;
  return {{{{1, 0, -slope.x()}, middle.x()},
           {{-1, 0, -slope.x()}, middle.x()},
           {{0, 1, -slope.y()}, middle.y()},
           {{0, -1, -slope.y()}, middle.y()},
           {{0, 0, -1}, -bottom},
           {{0, 0, 1}, top}}};
}

Crossing cross_faces(const Vec3& from, const Vec3& way, const std::array<HalfSpace, 6>& faces) {
  Crossing crossing;
  for (int i = 0; i < 6; ++i) {
    const HalfSpace& face = faces[static_cast<std::size_t>(i)];
    const double away = face.reach - face.n.dot(from), speed = face.n.dot(way);
    if (speed == 0) {
      if (away < 0) return {kNever, -kNever};
      continue;
    }
    const double at = away / speed;
    if (speed < 0) {
      if (at > crossing.in) crossing.in = at, crossing.in_face = i;
    } else if (at < crossing.out) {
      crossing.out = at, crossing.out_face = i;
    }
  }
  return crossing;
}

constexpr int kSide = 0, kBottom = 4, kTop = 5;  // faces; of a cone, too

/// Of a cone between two heights, with these radii at its ends.
Crossing cross_cone(const Vec3& from, const Vec3& way, double low, double high, double bottom, double top) {
  Crossing crossing;
  const auto limit = [&](double away, double speed, int face) {  // like a half space
    if (speed == 0) {
      if (away < 0) crossing.in = kNever, crossing.out = -kNever;
      return;
    }
    const double at = away / speed;
    if (speed < 0) {
      if (at > crossing.in) crossing.in = at, crossing.in_face = face;
    } else if (at < crossing.out) {
      crossing.out = at, crossing.out_face = face;
    }
  };
  limit(from.z() - bottom, -way.z(), kBottom);
  limit(top - from.z(), way.z(), kTop);
  if (!crossing.meets()) return crossing;
  // Between its ends the solid is where x^2 + y^2 <= (m + k z)^2.
  const double k = (high - low) / (top - bottom), m = low - k * bottom;
  const double width = m + k * from.z(), widening = k * way.z();
  const double a = way.head<2>().squaredNorm() - widening * widening;
  const double b = from.head<2>().dot(way.head<2>()) - width * widening;
  const double c = from.head<2>().squaredNorm() - width * width;
  const auto enters = [&](double at) {
    if (at > crossing.in) crossing.in = at, crossing.in_face = kSide;
  };
  const auto leaves = [&](double at) {
    if (at < crossing.out) crossing.out = at, crossing.out_face = kSide;
  };
  const auto never = [&] { crossing.in = kNever, crossing.out = -kNever; };
  const double root = b * b - a * c;
  if (a > 0) {
    if (root < 0) return never(), crossing;
    const double half = std::sqrt(root);
    enters((-b - half) / a);
    leaves((-b + half) / a);
  } else if (a < 0) {  // steeper than the cone: outside between the roots; the other nappe lies beyond one of them
    if (root < 0) return crossing;
    const double half = std::sqrt(root), first = (-b + half) / a, second = (-b - half) / a;
    widening > 0 ? enters(second) : leaves(first);
  } else if (b < 0) {
    enters(-c / (2 * b));
  } else if (b > 0) {
    leaves(-c / (2 * b));
  } else if (c > 0) {
    never();
  }
  return crossing;
}

Vec3 cone_normal(const Vec3& at, double low, double high, double bottom, double top) {
  const double k = (high - low) / (top - bottom), width = low + k * (at.z() - bottom);
  return Vec3(at.x(), at.y(), -k * width).normalized();
}

RayEntry enter_wedge(const RayTarget& solid, const Vec3& from, const Vec3& way) {
  const auto faces = faces_of(solid.low, solid.high, -1, 1);
  const Crossing crossing = cross_faces(from, way, faces);
  if (!crossing.meets() || crossing.in <= 0 || crossing.in_face < 0) return {};
  return {crossing.in, faces[static_cast<std::size_t>(crossing.in_face)].n};
}

RayEntry enter_cone(const RayTarget& solid, const Vec3& from, const Vec3& way) {
  const double low = solid.low.x(), high = solid.high.x();
  const Crossing crossing = cross_cone(from, way, low, high, -1, 1);
  if (!crossing.meets() || crossing.in <= 0 || crossing.in_face < 0) return {};
  if (crossing.in_face != kSide) return {crossing.in, Vec3(0, 0, crossing.in_face == kTop ? 1 : -1)};
  return {crossing.in, cone_normal(from + crossing.in * way, low, high, -1, 1)};
}

/// A hollow solid: the nearer of where the ray enters the outer body, but not through the mouth, and where it leaves
/// the hollow, but not through the mouth.
template <class Cross, class Normal>
RayEntry enter_hollow(const Cross& cross, const Normal& normal, const Vec3& from, const Vec3& way) {
  const Crossing outer = cross(false), inner = cross(true);
  const bool in_hollow = inner.meets() && inner.out > 0;
  const bool by_mouth = outer.in_face == kTop && inner.meets() && inner.in_face == kTop;
  RayEntry entry;
  if (outer.meets() && outer.in > 0 && outer.in_face >= 0 && !by_mouth)
    entry = {outer.in, normal(false, outer.in_face, from + outer.in * way)};
  if (in_hollow && inner.out_face != kTop && inner.out_face >= 0 && inner.out < entry.along)
    entry = {inner.out, -normal(true, inner.out_face, from + inner.out * way)};
  return entry;
}

RayEntry enter_cup(const RayTarget& solid, const Vec3& from, const Vec3& way) {
  const double low = solid.low.x(), high = solid.high.x(), bottom = -1 + solid.floor;
  const double inner_low = low + (high - low) * solid.floor / 2 - solid.wall, inner_high = high - solid.wall;
  const auto cross = [&](bool inner) {
    return inner ? cross_cone(from, way, inner_low, inner_high, bottom, 1) : cross_cone(from, way, low, high, -1, 1);
  };
  const auto normal = [&](bool inner, int face, const Vec3& at) -> Vec3 {
    if (face != kSide) return {0, 0, face == kTop ? 1.0 : -1.0};
    return inner ? cone_normal(at, inner_low, inner_high, bottom, 1) : cone_normal(at, low, high, -1, 1);
  };
  return enter_hollow(cross, normal, from, way);
}

RayEntry enter_crate(const RayTarget& solid, const Vec3& from, const Vec3& way) {
  const double bottom = -1 + solid.floor;
  const Vec2 wall = Vec2::Constant(solid.wall);
  const auto outer_faces = faces_of(solid.low, solid.high, -1, 1);
  const auto inner_faces =
      faces_of(solid.low + (solid.high - solid.low) * solid.floor / 2 - wall, solid.high - wall, bottom, 1);
  const auto cross = [&](bool inner) { return cross_faces(from, way, inner ? inner_faces : outer_faces); };
  const auto normal = [&](bool inner, int face, const Vec3&) -> Vec3 {
    return (inner ? inner_faces : outer_faces)[static_cast<std::size_t>(face)].n;
  };
  return enter_hollow(cross, normal, from, way);
}

}  // namespace

RayTarget::RayTarget(const Solid& solid)
    : to_own(solid.pose.rotation.toRotationMatrix().transpose()),
      forms(to_own),
      center(solid.pose.position),
      half(solid.size / 2),
      kind(solid.kind),
      sheared(solid.sheared),
      low(solid.low),
      high(solid.high),
      wall(solid.wall),
      floor(solid.floor) {
  if (!sheared) return;
  to_own = solid.axes.inverse();
  forms = solid.axes.transpose();
  half = Vec3::Ones();
}

Vec3 RayTarget::normal_in_w(const Vec3& own) const {
  const Vec3 normal = to_own.transpose() * own;
  return sheared ? normal.normalized() : normal;
}

RayEntry enter(const RayTarget& solid, const Vec3& from, const Vec3& way) {
  switch (solid.kind) {
    case SolidKind::Box:
      return enter_box(from, way, solid.half);
    case SolidKind::Cylinder:
      return enter_cylinder(from, way, solid.half);
    case SolidKind::Sphere:
      return enter_ball(from, way, solid.half.x());
    case SolidKind::Wedge:
      return enter_wedge(solid, from, way);
    case SolidKind::Cone:
      return enter_cone(solid, from, way);
    case SolidKind::Cup:
      return enter_cup(solid, from, way);
    case SolidKind::Crate:
      return enter_crate(solid, from, way);
  }
  return {};
}

}  // namespace unietp
