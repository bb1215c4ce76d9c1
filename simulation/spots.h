#pragma once

#include <functional>

#include "scene/scene.h"
#include "simulation/profile.h"
#include "simulation/shape.h"

namespace unietp {

/// What a receptacle is for a thing, whatever stands on it: whether it has a surface of the kind asked for, and one
/// that is large enough.
struct Offer {
  bool any_surface = false, any_fit = false;
};

/// Every pose, in W, at which place_on (or place_in, with `inside`) would let a thing of the size go, wherever the
/// agent stands and whatever is in the way: over each surface, on a fine grid, upright along the surface's axes; lying
/// where it is too tall and `alone`, with nothing in or on it. `visit` is called with each in turn and ends the search
/// by `false`. `shape`: the receptacle's.
Offer for_each_spot(const Node& receptacle, const Shape& shape, const Vec3& size, bool inside, bool alone,
                    const std::function<bool(const Pose&)>& visit);

/// From the body's axis, a vertical segment at `at`, to where a thing is let go, metres. The arm gets there when it is
/// at most the profile's reach.
double arm_length(const Vec3& spot, const Vec2& at, const Profile& profile);

/// Of the free spots within reach the one with the least of this is tried first, metres.
double effort(const Vec3& spot, const Vec2& at, const Profile& profile);

}  // namespace unietp
