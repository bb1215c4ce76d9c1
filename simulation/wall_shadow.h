#pragma once

#include <array>
#include <optional>

#include "simulation/walls.h"

namespace unietp {

/// The space behind the large face of a wall, as seen from a point: what lies wholly in it cannot be seen from there.
class WallShadow {
 public:
  /// nullopt where the point, `eye` (W, meters), is not in front of one of the two large faces.
  static std::optional<WallShadow> of(const WallPiece& wall, const Vec3& eye);

  /// Whether a sphere lies wholly in it. Conservative by a millimeter.
  bool hides(const Vec3& center, double radius) const;
  /// About how much of the view the wall takes up, steradians.
  double angle() const { return angle_; }

 private:
  struct Plane {
    Vec3 normal = Vec3::Zero();  // inward, of unit length
    double offset = 0;           // of its points along the normal
  };
  std::array<Plane, 5> planes_;  // of the face, and through its edges and the eye
  double angle_ = 0;
};

}  // namespace unietp
