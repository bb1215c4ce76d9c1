// Each operator of a goal, said in the paper's release and read by its rules, against our own reading on random traces.
#include "exports/release_goal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/rng.h"
#include "logic/evaluate.h"
#include "scene/trace.h"
#include "tests/end_to_end/release_reader.h"

namespace unietp {
namespace {

using ::testing::HasSubstr;

Category category(const std::string& name, bool movable) {
  Category one;
  one.name = name;
  one.movable = movable;
  one.size = Vec3::Ones();
  return one;
}

/// Mugs that get hot, cold, dirty and clean, and a shelf that holds things in one way.
Knowledge knowledge() {
  return Knowledge(Simulator::Ai2thor, {category("Mug", true), category("Plate", true), category("Shelf", false)}, {},
                   {}, {}, {});
}

Node node(const std::string& id, const std::string& category) {
  Node one;
  one.id = id;
  one.category = category;
  one.size = Vec3::Ones();
  return one;
}

Scene home() {
  Scene scene;
  scene.rooms = {{"kitchen_1", "kitchen", {Vec2(0, 0), Vec2(9, 0), Vec2(9, 9), Vec2(0, 9)}}};
  scene.nodes = {node("mug_1", "Mug"), node("mug_2", "Mug"), node("plate_1", "Plate"), node("shelf_1", "Shelf")};
  return scene;
}

Scene random_scene(Rng& rng) {
  Scene scene = home();
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    Node& one = scene.nodes.edit(i);
    one.states.set({rng.below(2) == 0 ? Predicate::Clean : Predicate::Dirty, ""});
    one.states.set({rng.below(3) == 0 ? Predicate::Hot : Predicate::RoomTemperature, ""});
    if (one.category != "Shelf" && rng.below(2) == 0) scene.edges.insert({Predicate::On, one.id, "shelf_1"});
  }
  if (rng.below(3) == 0) scene.agent.held = {"mug_1"};
  return scene;
}

testing::ReleaseGraph graph_of(const Scene& scene) {
  testing::ReleaseGraph graph;
  graph.nodes["robot_agent"].category = "agent";
  for (const Node& one : scene.nodes) {
    auto& own = graph.nodes[one.id];
    own.category = one.category;
    own.states[one.states.has(Predicate::Clean) ? "clean" : "dirty"] = nullptr;
    own.states[one.states.has(Predicate::Hot) ? "hot" : "normal_temperature"] = nullptr;
  }
  for (const Edge& edge : scene.edges) graph.edges.insert({edge.from, "on_receptacle", edge.to});
  for (const auto& id : scene.agent.held) graph.edges.insert({"robot_agent", "grasping", id});
  return graph;
}

TEST(ReleaseGoal, MeansTheSameOnRandomTraces) {
  const auto known = knowledge();
  const std::vector<std::string> goals{
      "(at-end (exists (?m - Mug) (hot ?m)))",
      "(exists (?m - Mug) (at-end (and (hot ?m) (not (dirty ?m)))))",
      "(exists (?m - Mug) (sometime (held ?m)))",
      "(forall (?m - Mug) (always (or (clean ?m) (hot ?m))))",
      "(exists (?m - Mug) (until (dirty ?m) (hot ?m)))",
      "(exists (?m - Mug) (before (hot ?m) (dirty ?m)))",
      "(before (exists (?m - Mug) (held ?m)) (exists (?p - Plate) (exists (?s - Shelf) (on ?p ?s))))",
      "(exists (?s - Shelf) (at-end (count >= 2 (?m - Mug) (on ?m ?s))))",
      "(at-end (count = 1 (?m - Mug) (hot ?m)))",
      "(exists (?s - Shelf) (at-end (count > (number (?m - Mug) (on ?m ?s)) (number (?p - Plate) (on ?p ?s)))))",
      "(exists (?x - (either Mug Plate)) (at-end (hot ?x)))",
      "(forall (?x - (either Mug Plate)) (at-end (imply (hot ?x) (clean ?x))))",
      "(sometime (exists (?m - Mug) (and (hot ?m) (sometime (held ?m)))))",
      "(sometime (exists (?p - Plate) (before (clean ?p) (hot ?p))))",
  };
  for (const auto& text : goals) {
    SCOPED_TRACE(text);
    const auto goal = parse_formula("goal", text, FormulaUse::Goal);
    ASSERT_TRUE(goal) << goal.error().message;
    std::size_t met = 0, tried = 0;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
      Rng rng(seed);
      std::vector<testing::ReleaseGraph> theirs;
      FactReader reader;
      Trace trace;
      const auto length = 1 + rng.below(5);
      Scene start;
      for (std::uint64_t i = 0; i < length; ++i) {
        const Scene scene = random_scene(rng);
        if (i == 0) start = scene;
        trace.states.push_back(reader.read(scene));
        theirs.push_back(graph_of(scene));
      }
      trace.entities = reader.entities();
      const auto said = release_goal(*goal, start, known, FormatFacts());
      ASSERT_TRUE(said) << said.error().message;
      const auto json = nlohmann::ordered_json::parse(said->json);
      const bool expected = holds(*goal, trace);
      ASSERT_EQ(testing::release_goal_holds(json, theirs, nlohmann::ordered_json::object()), expected)
          << json << " seed " << seed;
      met += expected ? 1 : 0;
      ++tried;
    }
    EXPECT_GT(met, 0U);
    EXPECT_LT(met, tried);
  }
}

TEST(ReleaseGoal, SaysWhyItCannotBeSaid) {
  const auto known = knowledge();
  const auto why = [&](const std::string& text) {
    const auto goal = parse_formula("goal", text, FormulaUse::Goal);
    const auto said = release_goal(*goal, home(), known, FormatFacts());
    return said ? std::string() : said.error().message;
  };
  EXPECT_THAT(why("(at-end (exists (?m - Mug) (exists (?n - Mug) (and (hot ?n) (not (= ?m ?n))))))"),
              HasSubstr("cannot compare objects"));
  EXPECT_THAT(why("(at-end (exists (?m - Mug) (frozen ?m)))"), HasSubstr("has no `frozen`"));
  EXPECT_THAT(why("(at-end (exists (?m - object) (hot ?m)))"), HasSubstr("all nodes"));
  EXPECT_THAT(why("(forall (?m - (Mug :where (dirty ?m))) (at-end (hot ?m)))"), HasSubstr("together with a reference"));
  EXPECT_THAT(why("(exists (?m - (Mug :where (dirty ?m))) (at-end (and (hot ?m) (count > (number (?a - Mug) (hot ?a)) "
                  "(number (?p - Plate) (hot ?p))))))"),
              HasSubstr("together with a reference"));
}

TEST(ReleaseGoal, WhatIsMeantIsNamed) {
  Scene start = home();
  start.nodes.edit(0).states.set({Predicate::Dirty, ""});
  start.nodes.edit(1).states.set({Predicate::Clean, ""});
  const auto goal =
      parse_formula("goal", "(exists (?m - (Mug :where (dirty ?m))) (at-end (hot ?m)))", FormulaUse::Goal);
  const auto said = release_goal(*goal, start, knowledge(), FormatFacts());
  ASSERT_TRUE(said) << said.error().message;
  EXPECT_EQ(said->referents, (std::map<std::string, std::vector<std::string>>{{"Mug", {"mug_1"}}}));
}

}  // namespace
}  // namespace unietp
