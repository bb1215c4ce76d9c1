#pragma once

#include "scene/geometry.h"

namespace unietp {

/// A level rectangle on which things can rest, object frame.
struct Surface {
  Vec3 center = Vec3::Zero();  // of the rectangle, on the solid's upper face
  Vec2 half = Vec2::Zero();    // half extents along x and y
  double clearance = 0;        // free height above it, meters
  int joint = -1;
  int cavity = -1;  // index of the cavity it is the floor or a shelf of; -1: open, what rests here is `on`
};

}  // namespace unietp
