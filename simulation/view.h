#pragma once

#include <vector>

#include "scene/scene.h"
#include "simulation/physics.h"
#include "simulation/profile.h"
#include "simulation/world.h"

namespace unietp {

/// What the agent's camera shows: objects whose box's centre is nearer than the profile's sight and of which at least
/// one of sight_points lies in the image and is met first by its ray. The pixel box is the projection of the object's
/// box, clipped to the image: an upper bound of what a renderer would draw. Sorted by id.
std::vector<VisibleObject> view_of(const Scene& scene, const PhysicsWorld& world, const Profile& profile);

}  // namespace unietp
