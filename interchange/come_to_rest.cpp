#include <algorithm>
#include <cmath>
#include <vector>

#include "interchange/draft.h"
#include "simulation/drift.h"
#include "simulation/relations.h"

namespace unietp {
namespace {

constexpr double kStill_m = 0.001;  // a round in which nothing moves farther is the last
constexpr double kRestless_m = 0.002;

void settle_in_rounds(Scene& scene) {
  constexpr int kMostRounds = 5;
  PhysicsWorld world = physics_of(scene);
  SettleOptions options;
  options.calm_steps = 240;  // a home is let go once: better to wait than to have something creep on
  double moved = 1;
  for (int round = 0; round < kMostRounds && moved > kStill_m; ++round) {
    moved = 0;
    for (const SettledBody& settled : world.settle(loose_bodies(scene), options).bodies) {
      Pose& pose = scene.nodes.edit(settled.body.index()).pose;
      moved = std::max(moved, (settled.pose.position - pose.position).norm());
      pose = settled.pose;
      world.move(settled.body, pose);
    }
  }
}

}  // namespace

void come_to_rest(const SourceScene& source, Draft& draft) {
  constexpr int kMostRounds = 10;  // a home that is not calm by then would take hours
  std::vector<Vec3> before;
  for (const Node& node : draft.scene.nodes) before.push_back(node.pose.position);
  settle_in_rounds(draft.scene);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double moved = (draft.scene.nodes[i].pose.position - before[i]).norm();
    if (moved > 0) draft.repairs.push_back({i, RepairKind::Settled, std::nullopt, moved});
  }
  const auto fix = [&](std::size_t node, std::string why) {
    const SourceObject& object = source.objects[draft.source_of[node]];
    draft.report.issues.push_back(
        {object.id, object.category, ImportReason::Restless, "cannot be moved: " + std::move(why)});
    draft.scene.nodes.edit(node).movable = false;
  };
  // Piles that no rigid bodies make keep creeping: they stay as they are, as furniture does.
  for (int round = 0; round < kMostRounds; ++round) {
    const auto restless = drifting(draft.scene, physics_of(draft.scene), kRestless_m);
    if (restless.empty()) return;
    for (const Drift& one : restless) {
      const long millimetres = std::lround(std::min(one.moved_m, 1000.0) * 1000);
      fix(one.node, "it drifts " + std::to_string(millimetres) + " mm in two seconds of physics and is fixed in place");
    }
  }
  for (const BodyId loose : loose_bodies(draft.scene))
    fix(loose.index(), "the home does not come to rest, and it is fixed in place with all the others");
}

}  // namespace unietp
