#include "grounding/home.h"
#include "grounding/given_home.h"

#include <algorithm>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grounding/workspace.h"
#include "homes.h"
#include "scene/fresh_id.h"
#include "scene/start.h"
#include "simulation/relations.h"
#include "simulation/world.h"

namespace unietp {
namespace {

/// A few things moved, opened, added, taken out (the last gets their place) and colored at random, settled or not.
Scene grown_out_of(const Scene& home, Rng rng) {
  Scene scene = home;
  for (int change = 0; change < 5; ++change) {
    const std::size_t i = rng.below(scene.nodes.size());
    Node& node = scene.nodes.edit(i);
    switch (rng.below(5)) {
      case 0:
        node.pose.position += Vec3(rng.uniform(-0.5, 0.5), rng.uniform(-0.5, 0.5), 0);
        break;
      case 1:
        if (node.openable) node.opening = 1 - node.opening;
        break;
      case 2: {
        Node more = node;
        more.id = fresh_id(scene, node.category);
        more.pose.position.z() += node.size.z();
        scene.nodes.push_back(more);
        break;
      }
      case 3:
        node = scene.nodes.back();
        scene.nodes.pop_back();
        break;
      default:
        node.color = "red";
    }
  }
  if (rng.chance(0.3)) scene.agent.position += Vec2(0.2, 0);
  return scene;
}

/// One a line, so that a difference can be read.
std::string texts(const EdgeSet& edges) {
  std::string all;
  for (const Edge& edge : edges) all += std::string(info(edge.relation).name) + " " + edge.from + " " + edge.to + "\n";
  return all;
}

EntityIndex place_of(const Trace& trace, const std::string& id) {
  const auto same = [&](const Entity& entity) { return entity.id == id; };
  const auto found = std::find_if(trace.entities.begin(), trace.entities.end(), same);
  return EntityIndex(found - trace.entities.begin());
}

/// The same state but for comparisons: every edge, nothing else between any two that `before` related, and the same
/// states and symbols.
void expect_shows(const Trace& now, const Scene& scene, const EdgeSet& before) {
  const Trace read = to_logic(scene, {});
  for (EntityIndex e; e.index() < now.entities.size(); ++e) {
    const EntityIndex there = place_of(read, now.entities[e].id);
    const bool exists = there.index() < read.entities.size();
    EXPECT_EQ(now.states.front().exists(e), exists) << now.entities[e].id;
    if (!exists) continue;
    for (const PredicateInfo& one : all_predicates()) {
      EXPECT_EQ(now.states.front().holds(one.predicate, e), read.states.front().holds(one.predicate, there));
    }
    EXPECT_EQ(now.states.front().holds(Predicate::Color, e, "red"),
              read.states.front().holds(Predicate::Color, there, "red"));
  }
  for (const Edge& edge : scene.edges) {
    EXPECT_TRUE(now.states.front().holds(edge.relation, place_of(now, edge.from), place_of(now, edge.to)));
  }
  for (const Edge& edge : before) {
    if (find_node(scene, edge.from) == nullptr || has_edge(scene, edge.relation, edge.from, edge.to)) continue;
    EXPECT_FALSE(now.states.front().holds(edge.relation, place_of(now, edge.from), place_of(now, edge.to)));
  }
}

/// Each id and each category is at the places where the scene has it.
void expect_places(const NodeIndex& places, const Scene& scene) {
  std::map<std::string, std::vector<std::size_t>> of;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    EXPECT_EQ(places.find(scene.nodes[i].id), i);
    of[scene.nodes[i].category].push_back(i);
  }
  for (const auto& [category, there] : of) EXPECT_EQ(places.of(category), there) << category;
}

TEST(Home, WhatIsReadAtTheCostOfTheDifferenceIsWhatAWholeReadingGives) {
  for (const Simulator simulator : {Simulator::Ai2thor, Simulator::Behavior}) {
    const auto style = style_of(simulator);
    ASSERT_TRUE(style);
    auto drawn = home_of(*style, 3);
    ASSERT_TRUE(drawn) << format(drawn.error());
    const Home home = prepare_home(std::move(*drawn), style->profile);
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      SCOPED_TRACE(seed);
      Scene scene = grown_out_of(home.scene, Rng(seed));
      const GrownScene grown = read_grown(home, scene);
      scene.edges = grown.edges.applied_to(home.scene.edges);
      expect_places(grown.places, scene);
      ASSERT_EQ(texts(scene.edges), texts(read_relations(scene)));
      expect_shows(grown.now, scene, home.scene.edges);

      const Walk whole = walk_in(scene, style->profile);
      EXPECT_EQ(grown.walk->reached, whole.reached);

      const auto afresh = World::create(scene, style->knowledge, style->profile);
      const auto from_home =
          World::create(scene, style->knowledge, style->profile, known_start(home, scene, read_grown(home, scene)));
      ASSERT_TRUE(afresh && from_home);
      EXPECT_TRUE(from_home->scene() == afresh->scene());
      for (const Node& node : scene.nodes)
        EXPECT_EQ(from_home->walking_distance(node.id), afresh->walking_distance(node.id)) << node.id;
    }
  }
}

TEST(Home, OfAGivenOneFurnitureThatNobodyGetsAtOrOpensIsOfNoUse) {
  const auto style = style_of(Simulator::Ai2thor);
  ASSERT_TRUE(style);
  auto drawn = home_of(*style, 3);
  ASSERT_TRUE(drawn) << format(drawn.error());
  const auto& all = drawn->nodes;
  const auto fridge = static_cast<std::size_t>(
      std::find_if(all.begin(), all.end(), [](const Node& node) { return node.category == "Fridge"; }) - all.begin());
  ASSERT_LT(fridge, all.size());
  const Home as_made = prepare_given_home(*drawn, style->profile);
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_TRUE(all[i].movable || is_of_use(as_made, i, true)) << all[i].id;

  Scene blocked = *drawn;
  Node box = all[fridge];  // right before its door
  box.id = "safe_99";
  box.category = "Safe";
  box.archetype = Archetype::Block;
  box.openable = false;
  box.pose = box.pose * Pose{Vec3(0, -box.size.y() - 0.01, 0), Quat::Identity()};
  blocked.nodes.push_back(box);
  const Home home = prepare_given_home(blocked, style->profile);
  EXPECT_TRUE(home.stuck[fridge]);
  EXPECT_FALSE(is_of_use(home, fridge, true));

  Scene lifted = *drawn;
  lifted.nodes.edit(fridge).pose.position.z() += 10;
  EXPECT_FALSE(is_of_use(prepare_given_home(lifted, style->profile), fridge, false));
  EXPECT_TRUE(is_of_use(prepare_home(lifted, style->profile), fridge, false)) << "generated homes are not looked at";
}

TEST(Home, AWorkspaceThatIsEditedAndReadAgainAndAgainShowsWhatAWholeReadingGives) {
  const auto style = style_of(Simulator::Virtualhome);
  ASSERT_TRUE(style);
  auto drawn = home_of(*style, 5);
  ASSERT_TRUE(drawn) << format(drawn.error());
  const Home home = prepare_home(std::move(*drawn), style->profile);
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Workspace workspace(home, style->knowledge);
    Rng rng(seed);
    for (int edit = 0; edit < 12; ++edit) {
      SCOPED_TRACE(::testing::Message() << "seed " << seed << ", edit " << edit);
      const EdgeSet before = start_in(home.scene, workspace.changes()).edges;
      const Scene next = grown_out_of(workspace.scene(), rng.fork("edit", static_cast<std::uint64_t>(edit)));
      while (workspace.scene().nodes.size() > next.nodes.size()) workspace.remove(workspace.scene().nodes.size() - 1);
      for (std::size_t i = 0; i < next.nodes.size(); ++i) {
        if (i >= workspace.scene().nodes.size()) {
          workspace.add(next.nodes[i]);
        } else if (workspace.scene().nodes[i] != next.nodes[i]) {
          workspace.replace(i, next.nodes[i]);
        }
      }
      workspace.agent() = next.agent;
      workspace.read_edges();
      Scene scene = workspace.scene();
      scene.edges = start_in(home.scene, workspace.changes()).edges;
      EXPECT_EQ(workspace.changes(), changes_of(home.scene, scene));
      ASSERT_EQ(texts(scene.edges), texts(read_relations(scene)));
      expect_shows(workspace.current_state().now(), scene, before);
      expect_places(workspace.places(), scene);
      for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Room* room = workspace.room_of(i);
        const Room* there = room_at(scene, scene.nodes[i].pose.position.head<2>());
        EXPECT_EQ(room == nullptr ? "" : room->id, there == nullptr ? "" : there->id);
        EXPECT_EQ(workspace.carried_by(i), carried_by(scene, scene.nodes[i].id));
      }
    }
  }
}

}  // namespace
}  // namespace unietp
