#pragma once

#include "scene/geometry.h"

namespace unietp {

// Habitat's frame is right-handed, y up, and a thing's front looks along its -z; W is z up and a thing's front looks
// along its -y. So W is Habitat's world turned a quarter about x, and an object frame half a turn about its upright.

/// A point or rotation of Habitat in W, and back.
inline Vec3 from_habitat(const Vec3& v) { return {v.x(), -v.z(), v.y()}; }
inline Vec3 to_habitat(const Vec3& v) { return {v.x(), v.z(), -v.y()}; }
/// The same of rotations.
inline Quat rotation_from_habitat(const Quat& q) { return Quat(q.w(), q.x(), -q.z(), q.y()) * Quat(0, 0, 0, 1); }
inline Quat rotation_to_habitat(const Quat& q) {
  const Quat turned = q * Quat(0, 0, 0, -1);
  return {turned.w(), turned.x(), turned.z(), -turned.y()};
}
/// Lengths along Habitat's axes of an asset ↔ width, depth, height.
inline Vec3 lengths_from_habitat(const Vec3& v) { return {v.x(), v.z(), v.y()}; }
inline Vec3 lengths_to_habitat(const Vec3& v) { return {v.x(), v.z(), v.y()}; }

}  // namespace unietp
