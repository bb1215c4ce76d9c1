#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "simulation/camera.h"
#include "simulation/solid.h"

namespace unietp {

/// Where the ray through the middle of a pixel enters the first solid on its way.
struct PixelHit {
  std::int32_t solid = -1;                                 // position in the list; -1: none
  double depth = std::numeric_limits<double>::infinity();  // meters along the view direction
  Vec3 normal = Vec3::UnitZ();                             // outwards, unit, W
};

/// The first solid at each pixel, rows from the top: the one that Rays::first finds there, of equally near ones the
/// first in the list, at a fraction of the cost. The image is split until outlines and depths decide which solid a part
/// of it shows, or until a part is so small that its pixels are decided one by one. Deterministic.
std::vector<PixelHit> first_solids(const std::vector<Solid>& solids, const Camera& camera);

}  // namespace unietp
