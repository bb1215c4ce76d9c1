#include <algorithm>

#include "interchange/draft.h"
#include "simulation/relations.h"

namespace unietp {

void come_to_rest(Draft& draft) {
  constexpr int kMostRounds = 5;
  constexpr double kStill_m = 0.001;  // a round in which nothing moves farther is the last
  PhysicsWorld world = physics_of(draft.scene);
  std::vector<BodyId> loose;
  for (std::size_t i = 0; i < draft.scene.nodes.size(); ++i) {
    if (draft.scene.nodes[i].movable) loose.push_back(static_cast<BodyId>(i));
  }
  SettleOptions options;
  options.calm_steps = 240;  // a home is let go once: better to wait than to have something creep on
  double moved = 1;
  for (int round = 0; round < kMostRounds && moved > kStill_m; ++round) {
    moved = 0;
    for (const SettledBody& settled : world.settle(loose, options).bodies) {
      Pose& pose = draft.scene.nodes[settled.body].pose;
      moved = std::max(moved, (settled.pose.position - pose.position).norm());
      pose = settled.pose;
      world.move(settled.body, pose);
    }
  }
}

}  // namespace unietp
