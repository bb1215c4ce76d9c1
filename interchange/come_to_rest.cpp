#include <algorithm>
#include <cmath>
#include <map>

#include "interchange/draft.h"
#include "simulation/relations.h"

namespace unietp {
namespace {

constexpr double kStill_m = 0.001;  // a round in which nothing moves farther is the last
constexpr double kRestless_m = 0.002, kRestless_s = 2;

std::vector<BodyId> loose_ones(const Scene& scene) {
  std::vector<BodyId> loose;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (scene.nodes[i].movable) loose.push_back(BodyId::node(i));
  }
  return loose;
}

void settle_in_rounds(Scene& scene) {
  constexpr int kMostRounds = 5;
  PhysicsWorld world = physics_of(scene);
  SettleOptions options;
  options.calm_steps = 240;  // a home is let go once: better to wait than to have something creep on
  double moved = 1;
  for (int round = 0; round < kMostRounds && moved > kStill_m; ++round) {
    moved = 0;
    for (const SettledBody& settled : world.settle(loose_ones(scene), options).bodies) {
      Pose& pose = scene.nodes.edit(settled.body.index()).pose;
      moved = std::max(moved, (settled.pose.position - pose.position).norm());
      pose = settled.pose;
      world.move(settled.body, pose);
    }
  }
}

struct Restless {
  std::size_t node = 0;
  double moved_m = 0;
};

/// What moves in two seconds of physics, in whichever order the solver takes the bodies: what rests in one order alone
/// starts to creep as soon as a task adds something elsewhere.
std::vector<Restless> restless_ones(const Scene& scene) {
  SettleOptions options;
  options.max_steps = options.calm_steps = static_cast<int>(std::lround(kRestless_s / options.step_s));
  const PhysicsWorld world = physics_of(scene);
  auto loose = loose_ones(scene);
  std::map<std::size_t, double> farthest;
  for (int order = 0; order < 2; ++order, std::reverse(loose.begin(), loose.end())) {
    for (const SettledBody& settled : world.settle(loose, options).bodies) {
      const double moved = (settled.pose.position - scene.nodes[settled.body.index()].pose.position).norm();
      if (moved <= kRestless_m) continue;  // not so what is no number
      double& so_far = farthest[settled.body.index()];
      so_far = std::max(so_far, std::isnan(moved) ? 1.0 : moved);
    }
  }
  std::vector<Restless> found;
  for (const auto& [node, moved] : farthest) found.push_back({node, moved});
  return found;
}

}  // namespace

void come_to_rest(const SourceScene& source, Draft& draft) {
  constexpr int kMostRounds = 10;  // a home that is not calm by then would take hours
  settle_in_rounds(draft.scene);
  const auto fix = [&](std::size_t node, std::string why) {
    const SourceObject& object = source.objects[draft.source_of[node]];
    draft.report.issues.push_back(
        {object.id, object.category, ImportReason::Restless, "cannot be moved: " + std::move(why)});
    draft.scene.nodes.edit(node).movable = false;
  };
  // Piles that no rigid bodies make keep creeping: they stay as they are, as furniture does.
  for (int round = 0; round < kMostRounds; ++round) {
    const auto restless = restless_ones(draft.scene);
    if (restless.empty()) return;
    for (const Restless& one : restless) {
      const long millimetres = std::lround(std::min(one.moved_m, 1000.0) * 1000);
      fix(one.node, "it drifts " + std::to_string(millimetres) + " mm in two seconds of physics and is fixed in place");
    }
  }
  for (const BodyId loose : loose_ones(draft.scene))
    fix(loose.index(), "the home does not come to rest, and it is fixed in place with all the others");
}

}  // namespace unietp
