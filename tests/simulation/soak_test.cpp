// Random action sequences on the kitchen: whatever an agent does, the world keeps its invariants. A fixed sample runs
// here; UNIETP_SOAK_SEQUENCES in the environment asks for a long run (docs/evidence.md records the last).
#include <cstdlib>
#include <set>

#include <gtest/gtest.h>

#include "core/rng.h"
#include "simulation/relations.h"
#include "simulation/world.h"
#include "tests/simulation/kitchen.h"

namespace unietp {
namespace {

constexpr double kDeepest_m = 0.004;  // resting contacts of a rigid-body solver sink by up to millimetres

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
    if (carried.contains(scene.nodes[i].id)) world.remove(static_cast<BodyId>(i));
  }
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    if (!node.movable || carried.contains(node.id)) continue;
    const BodyId self[] = {static_cast<BodyId>(i)};
    if (const auto other = world.overlap(shape_of(node), node.pose, node.opening, self, kDeepest_m)) {
      return node.id + " in " + (*other < scene.nodes.size() ? scene.nodes[*other].id : "a wall or the floor");
    }
  }
  return "";
}

TEST(Soak, RandomActionsNeverBreakTheWorld) {
  const char* asked = std::getenv("UNIETP_SOAK_SEQUENCES");
  const int sequences = asked != nullptr ? std::atoi(asked) : 60;
  const Knowledge knowledge = testing::kitchen_knowledge();
  const Profile profile = testing::kitchen_profile();
  const std::vector<ActionType> types{
      ActionType::GoTo,     ActionType::PickUp,   ActionType::PlaceOn, ActionType::PlaceIn,  ActionType::Open,
      ActionType::Close,    ActionType::TurnOn,   ActionType::TurnOff, ActionType::Slice,    ActionType::HeatWith,
      ActionType::WashWith, ActionType::CoolWith, ActionType::TurnTo,  ActionType::FillWith, ActionType::CookWith,
      ActionType::PourTo,   ActionType::UseUp};
  const std::vector<ActionType> alone{
      ActionType::MoveForward,     ActionType::MoveLeft,     ActionType::TurnRight,  ActionType::LookDown,
      ActionType::MoveHandForward, ActionType::MoveHandLeft, ActionType::RotateHand, ActionType::Drop};
  int succeeded = 0, steps = 0;
  for (int sequence = 0; sequence < sequences; ++sequence) {
    SCOPED_TRACE(sequence);
    Rng rng = Rng(7).fork("soak", static_cast<std::uint64_t>(sequence));
    World world = *World::create(testing::full_kitchen(Simulator::Ai2thor), knowledge, profile);
    for (int step = 0; step < 25; ++step) {
      // Half of the time near an object that was just gone to, so that much succeeds.
      const auto& nodes = world.scene().nodes;
      const std::string id = nodes[rng.below(nodes.size())].id;
      if (rng.chance(0.7)) (void)world.step({ActionType::GoTo, {id}});
      const Scene before = world.scene();
      const bool with_body = rng.chance(0.2);
      const Action action = with_body ? Action{rng.pick(alone), {}} : Action{rng.pick(types), {id}};
      const Outcome outcome = world.step(action);
      ++steps;
      SCOPED_TRACE(to_text(action));
      if (!outcome.success) {
        ASSERT_TRUE(world.scene() == before) << "a failed action changed something: " << outcome.feedback;
        continue;
      }
      ++succeeded;
      for (const Node& node : world.scene().nodes) ASSERT_TRUE(finite(node)) << node.id;
      ASSERT_EQ(deep_overlap(world.scene()), "");
      if (world.scene().agent.held.empty()) {
        ASSERT_EQ(world.scene().edges, read_relations(world.scene()));
      }
      for (const Node& node : world.scene().nodes) {  // nothing falls out of the room
        ASSERT_NE(room_at(world.scene(), node.pose.position.head<2>()), nullptr) << node.id;
        ASSERT_GT(node.pose.position.z(), -0.01) << node.id;
      }
    }
  }
  EXPECT_GT(succeeded, steps / 8);
}

}  // namespace
}  // namespace unietp
