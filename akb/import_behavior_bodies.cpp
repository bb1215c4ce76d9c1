#include <algorithm>
#include <array>
#include <cmath>

#include "akb/import_behavior.h"

// BEHAVIOR's boxes are of meshes as their makers laid them: bottles on their sides, coats spread out. A body stands or
// lies as people leave the thing, and is not thinner than physics can hold.
namespace unietp::behavior {
namespace {

constexpr double kRound = 1.25;        // larger : smaller side of what still passes for round
constexpr double kSlender = 3.5;       // higher than so many times its base falls over
constexpr double kFolded_m = 0.42;     // longest side of folded cloth
constexpr double kCloth_kg_m3 = 150;   // loosely folded
constexpr double kThinnest_m = 0.005;  // of what physics lays and picks up
constexpr double kSmallest_m = 0.012;  // sides of the smallest footprint

Vec3 sorted(Vec3 v) {
  std::sort(v.data(), v.data() + 3);
  return v;
}

/// Longest side across, smallest up.
Vec3 lying(const Vec3& size) {
  const Vec3 s = sorted(size);
  return {s.z(), s.y(), s.x()};
}

/// On its own side, or laid down when it is slender.
Vec3 at_rest(const Vec3& size) { return size.z() > kSlender * std::min(size.x(), size.y()) ? lying(size) : size; }

bool round(double a, double b) { return std::max(a, b) <= kRound * std::min(a, b); }

Vec3 folded(const Vec3& spread, double mass) {
  const Vec3 s = sorted(spread);
  double width = s.z(), depth = s.y();
  while (std::max(width, depth) > kFolded_m) (width > depth ? width : depth) /= 2;
  const double height = std::clamp(mass / (width * depth * kCloth_kg_m3), 0.01, 0.15);
  return {std::max(width, depth), std::min(width, depth), height};
}

/// The pair of sides that is nearest to a circle lies level.
Body cylinder(const Vec3& size) {
  const Vec3 s = sorted(size);
  const bool flat = s.z() / s.y() <= s.y() / s.x();
  const double a = flat ? s.z() : s.y(), b = flat ? s.y() : s.x(), height = flat ? s.x() : s.z();
  const double diameter = (a + b) / 2;
  if (round(a, b) && height <= kSlender * diameter) return {Archetype::Cylinder, {diameter, diameter, height}, {}};
  return {Archetype::Box, at_rest({a, b, height}), {}};
}

Body sphere(const Vec3& size) {
  const Vec3 s = sorted(size);
  if (round(s.x(), s.z())) return {Archetype::Sphere, Vec3::Constant(size.mean()), {}};
  return {Archetype::Box, at_rest(size), {}};
}

Body shaped(const Vec3& size, Archetype wanted) {
  switch (wanted) {
    case Archetype::Cylinder:
      return cylinder(size);
    case Archetype::Sphere:
      return sphere(size);
    case Archetype::Plate:
      return {wanted, lying(size), {}};
    case Archetype::Box:
      return {wanted, at_rest(size), {}};
    default:
      return {wanted, size, {}};
  }
}

}  // namespace

Body body_of(const Facts& facts, Archetype wanted) {
  std::vector<Vec3> boxes;
  for (const auto& [name, size] : facts.models) boxes.push_back(size);
  const Vec3 box = median(boxes);
  const bool cloth = facts.properties.contains("cloth") && wanted == Archetype::Box;
  Body body = cloth ? Body{wanted, folded(box, facts.mass), {}} : shaped(box, wanted);
  body.source = {cloth ? "derived:folded" : kInventory, cloth ? 0.7 : 0.9};
  const bool standing = body.archetype == Archetype::Panel;
  const Vec3 least(kSmallest_m, standing ? kThinnest_m : kSmallest_m, kThinnest_m);
  if ((body.size.array() < least.array()).any()) {
    const bool ball = body.archetype == Archetype::Sphere;
    body.size = ball ? Vec3::Constant(kSmallest_m) : Vec3(body.size.cwiseMax(least));
    body.source = {"derived:smallest-body", 0.8};
  }
  body.size = (body.size * 1000).array().round() / 1000;
  return body;
}

}  // namespace unietp::behavior
