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

/// False when the work did not suffice.
bool settle_in_rounds(Scene& scene, std::size_t& work) {
  constexpr int kMostRounds = 5;
  PhysicsWorld world = physics_of(scene);
  SettleOptions options;
  options.calm_steps = 240;  // a home is let go once: better to wait than to have something creep on
  double moved = 1;
  for (int round = 0; round < kMostRounds && moved > kStill_m; ++round) {
    moved = 0;
    options.most_work = work;
    const Settled all = world.settle(loose_bodies(scene), options);
    work -= std::min(work, all.work);
    if (work == 0) return false;
    for (const SettledBody& settled : all.bodies) {
      Pose& pose = scene.nodes.edit(settled.body.index()).pose;
      moved = std::max(moved, (settled.pose.position - pose.position).norm());
      pose = settled.pose;
      world.move(settled.body, pose);
    }
  }
  return true;
}

}  // namespace

void come_to_rest(const SourceScene& source, std::size_t most_work, Draft& draft) {
  constexpr int kMostRounds = 10;  // a home that is not calm by then would take hours
  const auto fix = [&](std::size_t node, std::string why) {
    const SourceObject& object = source.objects[draft.source_of[node]];
    draft.report.issues.push_back(
        {object.id, object.category, ImportReason::Restless, "cannot be moved: " + std::move(why)});
    draft.scene.nodes.edit(node).movable = false;
  };
  const auto fix_all = [&](const std::string& why) {
    for (const BodyId loose : loose_bodies(draft.scene)) fix(loose.index(), why);
  };
  const SharedList<Node> as_in_file = draft.scene.nodes;
  std::size_t work = most_work;
  if (!settle_in_rounds(draft.scene, work)) {
    draft.scene.nodes = as_in_file;
    return fix_all("the home is too crowded to come to rest in bounded time; everything stays where the file has it");
  }
  for (std::size_t i = 0; i < as_in_file.size(); ++i) {
    const double moved = (draft.scene.nodes[i].pose.position - as_in_file[i].pose.position).norm();
    if (moved > 0) draft.repairs.push_back({i, RepairKind::Settled, std::nullopt, moved});
  }
  // Piles that no rigid bodies make keep creeping: they stay as they are, as furniture does.
  for (int round = 0; round < kMostRounds; ++round) {
    const auto restless = drifting(draft.scene, physics_of(draft.scene), kRestless_m, work);
    if (work == 0) break;
    if (restless.empty()) return;
    for (const Drift& one : restless) {
      const long millimeters = std::lround(std::min(one.moved_m, 1000.0) * 1000);
      fix(one.node, "it drifts " + std::to_string(millimeters) + " mm in two seconds of physics and is fixed in place");
    }
  }
  fix_all("the home does not come to rest, and it is fixed in place with all the others");
}

}  // namespace unietp
