#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "simulation/channels.h"
#include "simulation/solids.h"
#include "simulation/view.h"
#include "simulation/visible_box.h"

namespace unietp::testing {

/// The pixels of a node in an image, and the box around them.
struct SeenByRays {
  std::size_t pixels = 0;
  PixelBox box = kNowhere;
};

/// Of each node, by the rays through the pixels alone.
inline std::vector<SeenByRays> pixels_by_rays(const Segmentation& image, std::size_t nodes) {
  std::vector<SeenByRays> seen(nodes);
  std::vector<std::size_t> last(nodes, image.node.size());
  const auto shows = [&](std::size_t pixel, std::int32_t node) {
    if (node < 0 || std::exchange(last[static_cast<std::size_t>(node)], pixel) == pixel) return;
    const int x = static_cast<int>(pixel) % image.width, y = static_cast<int>(pixel) / image.width;
    SeenByRays& one = seen[static_cast<std::size_t>(node)];
    ++one.pixels;
    one.box = around(one.box, {x, y, x, y});
  };
  auto through = image.through.begin();
  for (std::size_t pixel = 0; pixel < image.node.size(); ++pixel) {
    shows(pixel, image.node[pixel]);
    for (; through != image.through.end() && through->pixel == pixel; ++through) shows(pixel, through->node);
  }
  return seen;
}

/// The pixels that show a node if nothing is before it.
inline std::size_t silhouette_by_rays(const Scene& scene, std::size_t node, const Camera& camera, Rays& rays) {
  std::vector<Solid> solids;
  add_solids(scene.nodes[node], static_cast<std::int32_t>(node), scene.simulator, walls_of(scene), solids);
  rays.build(std::move(solids));
  const Vec3 way = scene.nodes[node].pose.position - camera.at;
  const double radius = sight_radius(scene.nodes[node]);
  std::size_t pixels = 0;
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const Vec3 direction = camera.ray(x + 0.5, y + 0.5);
      if (way.cross(direction).squaredNorm() > radius * radius * direction.squaredNorm()) continue;
      pixels += rays.first(camera.at, direction, kEndless_m) ? 1 : 0;
    }
  }
  return pixels;
}

/// The boxes of the nodes that count as seen, by rays alone and without a limit of sight: what a view has to find.
inline std::vector<std::optional<PixelBox>> boxes_by_rays(const Scene& scene, const Profile& profile,
                                                          const Segmentation& image, Rays& rays) {
  const Camera camera = camera_of(scene.agent, profile);
  const auto seen = pixels_by_rays(image, scene.nodes.size());
  std::vector<std::optional<PixelBox>> boxes(seen.size());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i].pixels < std::size_t{kLeastSeenPixels}) continue;
    const bool sure = kLeastSeenPart * seen[i].pixels >= image.node.size();
    if (sure || kLeastSeenPart * seen[i].pixels >= silhouette_by_rays(scene, i, camera, rays)) boxes[i] = seen[i].box;
  }
  return boxes;
}

}  // namespace unietp::testing
