// The knowledge base says what goes on and into what; physics must agree: a body that holds the object can put it
// there.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "simulation/feedback.h"
#include "simulation/world.h"
#include "tests/simulation/kitchen.h"
#include "tests/support/committed_knowledge.h"

namespace unietp {
namespace {

/// A bare room with one receptacle, open, and the object on the floor in a far corner.
Scene bare_room(const Knowledge& knowledge, const Placement& row, double body_height) {
  Scene scene;
  scene.id = "bare";
  scene.simulator = knowledge.simulator();
  scene.rooms = {{"room_1", "kitchen", {{0, 0}, {6, 0}, {6, 6}, {0, 6}}}};
  const Category& receptacle = *knowledge.find(row.receptacle);
  // Small appliances and movable receptacles stand at the height of a counter when that leaves them within reach.
  Node& node = testing::add(scene, "receptacle", knowledge, row.receptacle, 3, 3, 0);
  if (receptacle.size.z() < 0.5) {
    const Category counter = [] {
      Category c;
      c.name = "block";
      c.archetype = Archetype::Block;
      c.size = Vec3(1, 1, 0.8);
      return c;
    }();
    node.pose.position.z() += 0.801;
    Node support = node;
    support.id = "support";
    support.category = row.receptacle;
    support.movable = false;
    support.openable = false;
    support.archetype = counter.archetype;
    support.size = Vec3(node.size.x() + 0.05, node.size.y() + 0.05, 0.8);
    support.pose = upright(Vec3(3, 3, 0.4), 0);
    support.states = {};
    scene.nodes.push_back(support);
  }
  Node& holder = *edit_node(scene, "receptacle");
  if (holder.openable && row.relation == Predicate::Inside) {
    holder.opening = 1;
    holder.states.set({Predicate::Open, ""});
  }
  testing::add(scene, "object", knowledge, row.object, 3, 3, body_height);
  scene.agent.held = {"object"};
  scene.agent.position = {5.5, 0.5};
  return scene;
}

/// Rows to try: all of them when UNIETP_EVERY_PLACEMENT is set in the environment (minutes), else as many of each pair
/// of archetypes and relation, spread evenly over the table, that a simulator's rows reach kRows.
std::vector<Placement> sampled(const Knowledge& knowledge) {
  constexpr std::size_t kRows = 800;
  std::map<std::tuple<Predicate, Archetype, Archetype>, std::vector<const Placement*>> groups;
  for (const Placement& row : knowledge.placements()) {
    if (row.relation != Predicate::On && row.relation != Predicate::Inside) continue;
    if (!knowledge.has(row.object, "pickupable")) continue;
    const auto archetype = [&](const std::string& name) { return knowledge.find(name)->archetype; };
    groups[{row.relation, archetype(row.object), archetype(row.receptacle)}].push_back(&row);
  }
  const bool every = std::getenv("UNIETP_EVERY_PLACEMENT") != nullptr;
  const auto drawn = [&](std::size_t most) {
    std::size_t count = 0;
    for (const auto& [key, group] : groups) count += std::min(most, group.size());
    return count;
  };
  std::size_t most = 1;
  while (drawn(most) < kRows && drawn(most + 1) > drawn(most)) ++most;
  std::vector<Placement> rows;
  for (const auto& [key, group] : groups) {
    const std::size_t count = every ? group.size() : std::min(most, group.size());
    for (std::size_t i = 0; i < count; ++i) rows.push_back(*group[i * group.size() / count]);
  }
  return rows;
}

class KnowledgeInPhysics : public ::testing::TestWithParam<Simulator> {};

TEST_P(KnowledgeInPhysics, WhatTheTablesPlaceABodyCanPlace) {
  const std::filesystem::path source = UNIETP_SOURCE_DIR;
  const Knowledge& knowledge = committed_knowledge(GetParam());
  const auto profile = load_profile(source / "data/simulators", GetParam());
  ASSERT_TRUE(profile) << format(profile.error());
  const auto rows = sampled(knowledge);
  for (const Placement& row : rows) {
    auto world = World::create(bare_room(knowledge, row, 1.0), knowledge, *profile);
    ASSERT_TRUE(world) << format(world.error());
    ActionResult outcome = world->step({ActionType::GoTo, {"receptacle"}});
    if (outcome.success) {
      outcome =
          world->step({row.relation == Predicate::On ? ActionType::PlaceOn : ActionType::PlaceIn, {"receptacle"}});
    }
    EXPECT_TRUE(outcome.success) << row.object << " " << info(row.relation).name << " " << row.receptacle << ": "
                                 << feedback_with_ids(outcome.detail);
  }
  EXPECT_GT(rows.size(), 500U);  // AI2-THOR has the fewest: 569
}

INSTANTIATE_TEST_SUITE_P(All, KnowledgeInPhysics, ::testing::ValuesIn(kSimulators),
                         [](const auto& simulator) { return std::string(name_of(simulator.param)); });

}  // namespace
}  // namespace unietp
