#include "interchange/draft.h"
#include "simulation/relations.h"

namespace unietp {

void come_to_rest(Draft& draft) {
  PhysicsWorld world = physics_of(draft.scene);
  std::vector<BodyId> loose;
  for (std::size_t i = 0; i < draft.scene.nodes.size(); ++i) {
    if (draft.scene.nodes[i].movable) loose.push_back(static_cast<BodyId>(i));
  }
  SettleOptions options;
  options.calm_steps = 240;  // a home is let go once: better to wait than to have something creep on
  for (const SettledBody& settled : world.settle(loose, options).bodies) {
    draft.scene.nodes[settled.body].pose = settled.pose;
  }
}

}  // namespace unietp
