#pragma once

#include <cstddef>
#include <vector>

#include "simulation/camera.h"
#include "simulation/finish.h"

namespace unietp {

/// A lamp, flame or screen that is on.
struct LightSource {
  Vec3 at = Vec3::Zero();      // W
  double strength = 0;         // at its middle, as a share of daylight
  const Room* room = nullptr;  // lights this room alone; nullptr: everything near
};
/// Of the nodes that are on, up to `farthest` meters from the camera.
std::vector<LightSource> light_sources(const Scene& scene, const std::vector<Look>& looks, const Camera& camera,
                                       double farthest);
/// Light at a point, of each color as a share of daylight.
Vec3 light_of(const std::vector<LightSource>& sources, const Vec3& at, const Vec3& normal);

/// A soft ball of steam or light in front of what is behind it.
struct Puff {
  Vec3 at = Vec3::Zero();  // W
  double radius = 0;       // meters
  Color color = Color::Zero();
  double strength = 0;  // share of the color in the middle
};
/// Steam over what is hot, light around what glows.
std::vector<Puff> puffs_of(const Node& node, const Look& look);

}  // namespace unietp
