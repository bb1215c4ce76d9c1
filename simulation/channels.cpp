#include "simulation/channels.h"

#include <limits>

#include "simulation/first_solids.h"
#include "simulation/solids.h"
#include "simulation/view.h"
#include "simulation/walls.h"

namespace unietp {

Channels channels_of(const Scene& scene, const Camera& camera) {
  const std::vector<Solid> solids = solids_of(scene, camera, kEndless_m, hidden_from_sight(scene));
  const std::vector<PixelHit> hits = first_solids(solids, camera);
  Channels channels{camera.width, camera.height, {}, {}, {}};
  channels.depth.reserve(hits.size());
  channels.normal.reserve(3 * hits.size());
  channels.node.reserve(hits.size());
  for (const PixelHit& hit : hits) {
    const int x = static_cast<int>(channels.depth.size()) % camera.width;
    const int y = static_cast<int>(channels.depth.size()) / camera.width;
    double depth = std::numeric_limits<double>::infinity();
    Vec3 normal = Vec3::Zero();  // W
    std::int32_t node = -1;
    if (hit.solid >= 0) {
      depth = hit.depth;
      normal = hit.normal;
      node = solids[static_cast<std::size_t>(hit.solid)].owner;
    } else if (const auto plane = plane_behind(camera.at, camera.ray(x + 0.5, y + 0.5), scene.wall_height)) {
      depth = plane->along;
      normal.z() = plane->is_floor ? 1 : -1;
    }
    channels.depth.push_back(static_cast<float>(depth));
    for (const Vec3& axis : {camera.right, camera.down, camera.ahead})
      channels.normal.push_back(static_cast<float>(normal.dot(axis)));
    channels.node.push_back(node);
  }
  return channels;
}

Segmentation segmentation_of(const Scene& scene, const Profile& profile, Rays& rays) {
  const Camera camera = camera_of(scene.agent, profile);
  rays.build(solids_of(scene, camera, kEndless_m, hidden_from_sight(scene)));
  Segmentation image{camera.width, camera.height, {}, {}};
  image.node.reserve(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height));
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const Vec3 direction = camera.ray(x + 0.5, y + 0.5);
      auto hit = rays.first(camera.at, direction, kEndless_m);
      const auto owner = [&] { return hit ? rays.solids()[hit->solid].owner : -1; };
      const std::size_t pixel = image.node.size();
      image.node.push_back(owner());
      while (hit && rays.solids()[hit->solid].clear) {
        hit = rays.next(camera.at, direction, kEndless_m, *hit);
        if (owner() >= 0) image.through.push_back({pixel, owner()});
      }
    }
  }
  return image;
}

}  // namespace unietp
