#pragma once

#include <array>
#include <optional>

#include "scene/geometry.h"
#include "scene/scene.h"

namespace unietp {

// Unity's frame (AI2-THOR, ProcTHOR, VirtualHome): left-handed, meters, y up; Euler angles in degrees, applied z, x, y;
// yaw turns clockwise seen from above. W = (x, z, y) of Unity. Models face Unity's +z, ours face -y of the object
// frame, so the frame of a model that is not turned in Unity is turned by 180° in W.

/// A point of Unity in W.
inline Vec3 from_unity(const Vec3& unity) { return {unity.x(), unity.z(), unity.y()}; }
inline Vec3 to_unity(const Vec3& w) { return {w.x(), w.z(), w.y()}; }  // the swap undoes itself

/// Full extents along a model's own axes (x, y up, z) in the object frame (width, depth, height), and back.
inline Vec3 extents_from_unity(const Vec3& unity) { return {unity.x(), unity.z(), unity.y()}; }

/// Object frame in W of a model with these Euler angles.
Quat rotation_from_unity(const Vec3& degrees);
/// The Euler angles of an object frame, each in [0, 360): the inverse within rounding.
Vec3 rotation_to_unity(const Quat& rotation);

/// An agent that Unity has at this place, with this yaw and tilt of the camera (down is positive), degrees.
Agent agent_from_unity(const Vec3& position, double yaw, double horizon);
/// The yaw in Unity's degrees, [0, 360), of an agent.
double agent_yaw_to_unity(const Agent& agent);

/// A box in the object frame.
struct PosedBox {
  Pose pose;  // of its center, W
  Vec3 size = Vec3::Zero();
};

/// The box with these eight corners (W, in any order), its axes named so that they come nearest to those of `facing`.
/// nullopt when they are no corners of a box.
std::optional<PosedBox> box_of_corners(const std::array<Vec3, 8>& corners, const Quat& facing);

/// The upright box that has this axis-aligned box around it (center and full extents, W), turned by the yaw of
/// `facing`: exact at right angles, solved for others; near 45°, where there is no one answer, the axis-aligned box.
PosedBox box_within(const Vec3& center, const Vec3& extents, const Quat& facing);

}  // namespace unietp
