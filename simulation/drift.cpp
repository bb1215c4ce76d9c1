#include "simulation/drift.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace unietp {

std::vector<BodyId> loose_bodies(const Scene& scene) {
  std::vector<BodyId> loose;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (scene.nodes[i].movable) loose.push_back(BodyId::node(i));
  }
  return loose;
}

std::vector<Drift> drifting(const Scene& scene, const PhysicsWorld& world, double allowed_m, std::size_t& work) {
  constexpr double kWatched_s = 2;
  SettleOptions options;
  options.max_steps = options.calm_steps = static_cast<int>(std::lround(kWatched_s / options.step_s));
  auto loose = loose_bodies(scene);
  std::map<std::size_t, double> farthest;
  for (int order = 0; order < 2; ++order, std::reverse(loose.begin(), loose.end())) {
    options.most_work = work;
    const Settled all = world.settle(loose, options);
    work -= std::min(work, all.work);
    for (const SettledBody& settled : all.bodies) {
      const std::size_t node = settled.body.index();
      const double moved = (settled.pose.position - scene.nodes[node].pose.position).norm();
      if (moved <= allowed_m) continue;  // not so what is no number
      double& so_far = farthest[node];
      so_far = std::max(so_far, std::isnan(moved) ? 1.0 : moved);
    }
  }
  std::vector<Drift> found;
  found.reserve(farthest.size());
  for (const auto& [node, moved] : farthest) found.push_back({node, moved});
  return found;
}

}  // namespace unietp
