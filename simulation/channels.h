#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene/scene.h"
#include "simulation/camera.h"
#include "simulation/profile.h"
#include "simulation/rays.h"

namespace unietp {

/// What lies on the ray through the middle of each pixel, rows from the top. Of the nearest surface, glass included.
struct Channels {
  int width = 0, height = 0;
  std::vector<float> depth;        // meters along the view direction, not along the ray; infinity where nothing is
  std::vector<float> normal;       // three a pixel, unit, camera frame: x right, y down, z ahead; 0 where nothing is
  std::vector<std::int32_t> node;  // position in Scene::nodes; -1 for walls, floor, ceiling and where nothing is
};

/// Of the solids that pictures, boxes and segmentation_of are made of, walls, floor and ceiling. Computed in double
/// precision and then rounded. Deterministic, the same bytes on every processor.
Channels channels_of(const Scene& scene, const Camera& camera);

/// Which node each pixel shows, rows from the top; -1 for walls, floor, ceiling and openings.
struct Segmentation {
  /// A node that a pixel shows through glass that lies before it.
  struct Through {
    std::size_t pixel = 0;
    std::int32_t node = -1;
    auto operator<=>(const Through&) const = default;
  };
  int width = 0, height = 0;
  std::vector<std::int32_t> node;  // the nearest
  std::vector<Through> through;    // by pixel, the nearest first; one may come again
};

/// One ray through the middle of every pixel, through all glass on its way, without a limit of sight. `rays` is scratch
/// space.
Segmentation segmentation_of(const Scene& scene, const Profile& profile, Rays& rays);

}  // namespace unietp
