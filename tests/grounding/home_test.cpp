#include "grounding/home.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "homes.h"
#include "simulation/relations.h"

namespace unietp {
namespace {

/// A few things moved, opened, added, taken out (the last gets their place) and coloured at random, settled or not.
Scene grown_out_of(const Scene& home, Rng rng) {
  Scene scene = home;
  for (int change = 0; change < 5; ++change) {
    const std::size_t i = rng.below(scene.nodes.size());
    Node& node = scene.nodes[i];
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
        std::swap(node, scene.nodes.back());
        scene.nodes.pop_back();
        break;
      default:
        node.colour = "red";
    }
  }
  if (rng.chance(0.3)) scene.agent.position += Vec2(0.2, 0);
  return scene;
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
      const PhysicsWorld physics = physics_of(home, scene);
      scene.edges = relations_of(home, scene, physics);
      ASSERT_EQ(scene.edges, read_relations(scene));

      const Walk whole = walk_in(scene, style->profile);
      EXPECT_EQ(walk_of(home, scene, style->profile)->steps, whole.steps);

      // The same state: every edge, nothing else between any two, and the same states and symbols.
      const Trace now = state_of(home, scene, seed % 2 == 0), read = to_logic(scene, {}, true);
      const auto place = [](const Trace& trace, const std::string& id) {
        for (EntityIndex e = 0; e < trace.entities.size(); ++e) {
          if (trace.entities[e].id == id) return e;
        }
        return static_cast<EntityIndex>(trace.entities.size());
      };
      for (EntityIndex e = 0; e < now.entities.size(); ++e) {
        const EntityIndex there = place(read, now.entities[e].id);
        const bool exists = there < read.entities.size();
        EXPECT_EQ(now.states.front().exists(e), exists) << now.entities[e].id;
        if (!exists) continue;
        for (const PredicateInfo& one : all_predicates()) {
          EXPECT_EQ(now.states.front().holds(one.predicate, e), read.states.front().holds(one.predicate, there));
        }
        EXPECT_EQ(now.states.front().holds(Predicate::Colour, e, "red"),
                  read.states.front().holds(Predicate::Colour, there, "red"));
      }
      for (const Edge& edge : scene.edges) {
        EXPECT_TRUE(now.states.front().holds(edge.relation, place(now, edge.from), place(now, edge.to)));
      }
      for (const Edge& edge : home.scene.edges) {
        if (find_node(scene, edge.from) == nullptr || has_edge(scene, edge.relation, edge.from, edge.to)) continue;
        EXPECT_FALSE(now.states.front().holds(edge.relation, place(now, edge.from), place(now, edge.to)));
      }
    }
  }
}

}  // namespace
}  // namespace unietp
