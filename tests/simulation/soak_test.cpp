// Random action sequences on the kitchen: whatever an agent does, the world keeps its invariants. A fixed sample runs
// here; UNIETP_SOAK_SEQUENCES in the environment asks for a long run (docs/evidence.md records the last).
#include <algorithm>
#include <cstdlib>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "core/rng.h"
#include "simulation/feedback.h"
#include "simulation/relations.h"
#include "simulation/solids.h"
#include "simulation/view.h"
#include "simulation/world.h"
#include "tests/simulation/kitchen.h"

namespace unietp {
namespace {

constexpr double kDeepest_m = 0.004;  // resting contacts of a rigid-body solver sink by up to millimeters

bool finite(const Node& node) { return node.pose.position.allFinite() && node.pose.rotation.coeffs().allFinite(); }

/// What the hands hold and what lies on or in it: carried past everything, so it may overlap.
std::set<std::string> in_hand(const Scene& scene) {
  std::set<std::string> carried(scene.agent.held.begin(), scene.agent.held.end());
  for (const std::string& id : scene.agent.held) {
    for (const std::string& other : carried_by(scene, id)) carried.insert(other);
  }
  return carried;
}

/// Pairs of solids that overlap deeper than kDeepest_m, as text.
std::string deep_overlap(const Scene& scene) {
  const std::set<std::string> carried = in_hand(scene);
  PhysicsWorld world = physics_of(scene);
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (carried.contains(scene.nodes[i].id)) world.remove(BodyId::node(i));
  }
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    if (!node.movable || carried.contains(node.id)) continue;
    const BodyId self[] = {BodyId::node(i)};
    if (const auto other = world.overlap(shape_of(node), node.pose, node.opening, self, kDeepest_m)) {
      return node.id + " in " + (other->is_node() ? scene.nodes[other->index()].id : "a wall or the floor");
    }
  }
  return "";
}

/// What is wrong with a world between two actions, as text; "" when nothing is.
std::string broken_invariant(const World& world) {
  const Scene& scene = world.scene();
  const std::set<std::string> carried = in_hand(scene);
  for (const Node& node : scene.nodes) {
    if (!finite(node)) return node.id + " is nowhere";
    if (carried.contains(node.id)) continue;
    if (room_at(scene, node.pose.position.head<2>()) == nullptr) return node.id + " is in no room";
    if (node.pose.position.z() < -0.01) return node.id + " is below the floor";
    const auto rooms = std::count_if(scene.edges.begin(), scene.edges.end(), [&](const Edge& edge) {
      return edge.relation == Predicate::InRoom && edge.from == node.id;
    });
    if (rooms != 1) return node.id + " is in " + std::to_string(rooms) + " rooms";
  }
  for (const Edge& edge : scene.edges) {
    if (edge.relation == Predicate::On && has_edge(scene, Predicate::Inside, edge.from, edge.to))
      return edge.from + " is on and inside " + edge.to;
    if (edge.relation == Predicate::Attached && !has_edge(scene, Predicate::On, edge.from, edge.to))
      return edge.from + " is attached to " + edge.to + " from afar";
  }
  const auto hidden = hidden_from_sight(scene);
  const NodeIndex places(scene.nodes);
  for (const VisibleObject& object : world.visible()) {
    const auto place = places.find(object.id).value();
    if (std::binary_search(hidden.begin(), hidden.end(), place)) return object.id + " is seen though hidden";
  }
  for (const auto& [seen, sight_m] :
       {std::pair(world.visible(), world.profile().sight_m), std::pair(world.pictured(), kEndless_m)}) {
    if (seen != Viewer(scene).view(viewed(scene), scene.agent, world.profile(), sight_m))
      return "what is seen is not what a first look sees";
  }
  if (const std::string pair = deep_overlap(scene); !pair.empty()) return pair;
  if (!scene.agent.held.empty()) return "";
  EdgeSet edges = scene.edges;
  erase_if(edges, [](const Edge& edge) { return edge.relation == Predicate::Attached; });
  return edges == read_relations(scene) ? "" : "the edges are not those that a fresh reading gives";
}

/// What an agent may be offered, in all four simulators and both profiles in turn, at random.
TEST(Soak, RandomActionsNeverBreakTheWorld) {
  const char* asked = std::getenv("UNIETP_SOAK_SEQUENCES");
  const int sequences = asked != nullptr ? std::atoi(asked) : 80;
  int succeeded = 0, steps = 0;
  for (int sequence = 0; sequence < sequences; ++sequence) {
    SCOPED_TRACE(sequence);
    const Simulator simulator = kSimulators[static_cast<std::size_t>(sequence % 4)];
    const auto actions = sequence / 4 % 2 == 0 ? ActionProfile::Unietp : ActionProfile::Wide;
    const Knowledge knowledge = testing::kitchen_knowledge(simulator);
    const Profile profile = testing::kitchen_profile(simulator, actions);
    std::vector<const ActionInfo*> alone, on_things;
    for (const auto list : {all_actions(), extension_actions()}) {
      for (const ActionInfo& action : list) {
        if (!profile.offers(action.type) || action.type == ActionType::Stop) continue;
        (action.argument == ActionArgument::None ? alone : on_things).push_back(&action);
      }
    }
    Rng rng = Rng(7).fork("soak", static_cast<std::uint64_t>(sequence));
    World world = *World::create(testing::wide_kitchen(simulator), knowledge, profile);
    for (int step = 0; step < 25; ++step) {
      // Mostly near an object that was just gone to, so that much succeeds.
      const auto& nodes = world.scene().nodes;
      const std::string id = nodes[rng.below(nodes.size())].id;
      if (rng.chance(0.7)) (void)world.step({ActionType::GoTo, {id}});
      const Scene before = world.scene();
      const bool with_body = rng.chance(0.2);
      const Action action = with_body ? Action{rng.pick(alone)->type, {}} : Action{rng.pick(on_things)->type, {id}};
      const ActionResult outcome = world.step(action);
      ++steps;
      SCOPED_TRACE(std::string(name_of(simulator)) + " " + to_text(action));
      if (!outcome.success) {
        ASSERT_TRUE(world.scene() == before)
            << "a failed action changed something: " << feedback_with_ids(outcome.detail);
        continue;
      }
      ++succeeded;
      ASSERT_EQ(broken_invariant(world), "");
    }
  }
  EXPECT_GT(succeeded, steps / 8);
}

}  // namespace
}  // namespace unietp
