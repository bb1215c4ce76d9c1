#pragma once

#include <vector>

#include "scene/scene.h"
#include "simulation/profile.h"
#include "simulation/rays.h"
#include "simulation/world.h"

namespace unietp {

/// What the agent's camera shows: objects whose box's centre is nearer than the profile's sight and that are what at
/// least one of the cast rays meets first. Rays go through the middles of pixels: a grid over where each object would
/// be seen, its salient points, and then lines outwards from what was seen. So an object is listed only if the image
/// (picture.h) has a pixel of it, its box holds only such pixels' places, and misses at most a few pixels at its rim.
/// Sorted by id. `rays` is a workplace: what it held before does not matter.
std::vector<VisibleObject> view_of(const Scene& scene, const Profile& profile, Rays& rays);

}  // namespace unietp
