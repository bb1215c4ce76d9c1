#pragma once

#include <vector>

#include "scene/archetype.h"
#include "scene/geometry.h"
#include "scene/scene.h"
#include "simulation/surface.h"

namespace unietp {

/// One convex solid of an object, in the object's frame with every joint closed.
struct Part {
  enum class Kind { Box, Cylinder, Sphere };  // cylinders stand along z
  Kind kind = Kind::Box;
  Pose pose;
  Vec3 size = Vec3::Zero();  // full extents, meters
  int joint = -1;            // moves with this joint; -1: with the body
};

/// A door's or lid's hinge, or a drawer's slide. Position = opening × travel, opening in [0, 1].
struct Joint {
  enum class Kind { Hinge, Slide };
  Kind kind = Kind::Hinge;
  Vec3 anchor = Vec3::Zero();  // a point on the hinge's axis, object frame
  Vec3 axis = Vec3::UnitZ();   // unit
  double travel = 0;           // radians or meters
};

/// A hollow space: what lies in it is `inside`.
struct Cavity {
  Vec3 center = Vec3::Zero(), half = Vec3::Zero();
  int joint = -1;           // slides with this joint (a drawer)
  bool closable = false;    // hidden and out of reach while the joints are closed
  bool open_above = false;  // things may stick out at the top
};

/// The geometry of an object, object frame.
struct Shape {
  std::vector<Part> parts;
  std::vector<Joint> joints;
  std::vector<Surface> surfaces;
  std::vector<Cavity> cavities;
};

/// Solids, joints, surfaces and cavities of an archetype scaled to `size`. Walls are kWall_m thick, less for small
/// things. Deterministic. Every entry of `size` > 0.
Shape make_shape(Archetype archetype, const Vec3& size, bool openable);
/// The shape of one object: its archetype's, or, when it has boards, those as its solids with a surface on each that
/// has room above it; joints and cavities stay the archetype's. A board of a joint that the archetype lacks is fixed.
Shape shape_of(const Node& node);

/// Object frame, closed → object frame at this opening, for things that move with the joint (-1: identity).
Pose joint_motion(const Shape& shape, int joint, double opening);

/// Bounds in W of the whole shape, doors at `opening`.
Bounds bounds_of(const Shape& shape, const Pose& pose, double opening);

}  // namespace unietp
