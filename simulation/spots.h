#pragma once

#include <functional>

#include "scene/scene.h"
#include "simulation/profile.h"
#include "simulation/shape.h"

namespace unietp {

/// Whether a receptacle, when empty, has a surface of the kind asked for, and one that is large enough for an object.
struct SurfaceFit {
  bool any_surface = false, any_fit = false;
};

/// Every pose, in W, at which place_on (or place_in, with `inside`) would release an object of that size,
/// regardless of the agent's position and of obstacles: over each surface, on a fine grid, upright along the surface's
/// axes; lying where it is too tall and `alone` (nothing is in or on it). `visit` is called with each in turn and
/// returns false to end the search. `shape`: the receptacle's.
SurfaceFit for_each_spot(const Node& receptacle, const Shape& shape, const Vec3& size, bool inside, bool alone,
                         const std::function<bool(const Pose&)>& visit);

/// From the body's axis, a vertical segment at `at`, to a release point, meters. In reach when at most the profile's
/// reach.
double arm_length(const Vec3& spot, const Vec2& at, const Profile& profile);

/// Cost of a release point, meters: of the free spots in reach the one with the least is tried first. `arm`: its
/// arm_length.
double effort(const Vec3& spot, double arm);

}  // namespace unietp
