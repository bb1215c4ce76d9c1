#include "simulation/ray_entry.h"

#include <algorithm>
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

}  // namespace

RayTarget::RayTarget(const Solid& solid)
    : to_own(solid.pose.rotation.toRotationMatrix().transpose()),
      centre(solid.pose.position),
      half(solid.size / 2),
      kind(solid.kind) {}

RayEntry enter(const RayTarget& solid, const Vec3& from, const Vec3& way) {
  switch (solid.kind) {
    case Part::Kind::Box:
      return enter_box(from, way, solid.half);
    case Part::Kind::Cylinder:
      return enter_cylinder(from, way, solid.half);
    case Part::Kind::Sphere:
      return enter_ball(from, way, solid.half.x());
  }
  return {};
}

}  // namespace unietp
