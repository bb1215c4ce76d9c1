#pragma once

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "scene/geometry.h"
#include "scene/scene.h"
#include "simulation/digest.h"
#include "simulation/shape.h"

namespace unietp {

/// One convex solid with its joint moved: in the object's frame, or, once placed, in W.
struct Convex {
  Part::Kind kind = Part::Kind::Box;
  Vec3 center = Vec3::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // columns: the solid's own x, y, z
  Vec3 half = Vec3::Zero();
  Bounds bounds;
};

/// A shape at one joint position, as used in collision tests. Shared by all bodies with the same shape.
struct Collider {
  Collider(Shape of, double opening);

  Shape shape;
  double opening = 0;
  std::vector<Convex> parts;                        // object frame
  Vec3 center = Vec3::Zero(), half = Vec3::Zero();  // of the box around all parts, kSkin_m larger on each side
  bool rolls = false;
  Digest digest;  // of all of the above: equal colliders have equal ones

  /// Bounds in W of the body at a pose, kSkin_m larger; and its solids there.
  Bounds bounds(const Pose& pose) const;
  std::vector<Convex> placed(const Pose& pose) const;
};

/// Margin of bodies' bounds, so that touching bodies are found.
inline constexpr double kSkin_m = 0.001;

/// Cache of colliders by shape. Not thread-safe.
class ColliderCache {
 public:
  /// The collider of a node at its present opening.
  std::shared_ptr<const Collider> of(const Node& node);

 private:
  std::unordered_map<std::string, std::shared_ptr<const Collider>> known_;  // never iterated
};

}  // namespace unietp
