#pragma once

#include <cmath>
#include <string_view>

#include "interchange/unity.h"
#include "scene/geometry.h"

namespace unietp {

/// The same turn in the other frame. A swap of two axes mirrors: a turn keeps its angle about the mirrored axis, turned
/// the other way.
inline Quat turn_from_unity(const Quat& q) { return {q.w(), -q.x(), -q.z(), -q.y()}; }

/// From our object frame (front along -y) to the prefab's: prefabs named PRE_… look along Unity's x, the others along
/// its z. Source: in upstream's table of prefab sizes, boxes that hang on a wall stand out from their pivot that way.
inline Quat front_turn(std::string_view prefab) {
  const double half = std::sqrt(0.5);
  return prefab.starts_with("PRE_") ? Quat(half, 0, 0, half) : Quat(0, 0, 0, 1);
}

/// The rotation of a prefab's object in W, and back.
inline Quat object_rotation_from_unity(const Quat& q, std::string_view prefab) {
  return turn_from_unity(q) * front_turn(prefab);
}
inline Quat object_rotation_to_unity(const Quat& q, std::string_view prefab) {
  return turn_from_unity(q * front_turn(prefab).conjugate());
}

/// Scales along Unity's axes of the prefab ↔ along width, depth, height.
inline Vec3 scale_from_unity(const Vec3& v, std::string_view prefab) {
  return prefab.starts_with("PRE_") ? Vec3(v.z(), v.x(), v.y()) : Vec3(v.x(), v.z(), v.y());
}
inline Vec3 scale_to_unity(const Vec3& v, std::string_view prefab) {
  return prefab.starts_with("PRE_") ? Vec3(v.y(), v.z(), v.x()) : Vec3(v.x(), v.z(), v.y());
}

}  // namespace unietp
