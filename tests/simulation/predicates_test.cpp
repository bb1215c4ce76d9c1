// For every predicate and simulator a pair: set in a scene that was let come to rest, it reads true; and its reverse
// does not.
#include <algorithm>
#include <functional>
#include <map>

#include <gtest/gtest.h>

#include "core/text.h"
#include "scene/scene_json.h"
#include "scene/trace.h"
#include "simulation/relations.h"
#include "simulation/world.h"
#include "tests/simulation/kitchen.h"

namespace unietp {
namespace {

/// How a predicate is made true, and what must hold then and what must not: "on mug_1 plate_1".
struct Pair {
  std::function<void(Scene&)> set;
  std::vector<std::string> holds, reverse;
};

Node& node(Scene& scene, const char* id) { return *edit_node(scene, id); }

Pair state(Predicate predicate, Predicate opposite, const std::string& id = "mug_1") {
  const auto text = [&](Predicate p) { return std::string(info(p).name) + " " + id; };
  return {[=](Scene& scene) {
            node(scene, id.c_str()).states.set({predicate, ""});
          },
          {text(predicate)},
          {text(opposite)}};
}

/// Puts one object upright above another place, a hair above `z`.
std::function<void(Scene&)> moved(const char* id, double x, double y, double z) {
  return [=](Scene& scene) {
    Node& thing = node(scene, id);
    thing.pose = upright(Vec3(x, y, z + thing.size.z() / 2 + 0.002), 0);
  };
}

std::map<Predicate, Pair> pairs() {
  using enum Predicate;
  std::map<Predicate, Pair> all;
  for (const StateGroup& group : state_groups()) {
    for (std::size_t i = 0; i < group.predicates.size(); ++i) {
      const Predicate one = group.predicates[i], other = group.predicates[(i + 1) % group.predicates.size()];
      if (one != Filled && other != Filled) all[one] = state(one, other);
    }
  }
  const auto with_symbol = [](Predicate predicate, const char* symbol) {
    return [=](Scene& scene) { node(scene, "mug_1").states.set({predicate, symbol}); };
  };
  all[Empty] = {[](Scene& scene) {
                  node(scene, "mug_1").states.set({Empty, ""});
                },
                {"empty mug_1"},
                {"filled mug_1 any"}};
  all[Filled] = {with_symbol(Filled, "water"), {"filled mug_1 water"}, {"filled mug_1 wine", "empty mug_1"}};
  all[Covered] = {with_symbol(Covered, "dust"), {"covered mug_1 dust"}, {"covered mug_1 ketchup"}};
  all[Size] = {with_symbol(Size, "large"), {"size mug_1 large"}, {"size mug_1 small"}};
  all[SatOn] = {[](Scene& scene) {
                  node(scene, "sofa_1").states.set({SatOn, ""});
                },
                {"sat_on sofa_1"},
                {"lain_on sofa_1"}};
  all[LainOn] = {[](Scene& scene) {
                   node(scene, "sofa_1").states.set({LainOn, ""});
                 },
                 {"lain_on sofa_1"},
                 {"sat_on sofa_1"}};
  all[Read] = {[](Scene& scene) { node(scene, "mug_1").states.set({Read, ""}); }, {"read mug_1"}, {"read plate_1"}};
  all[Held] = {
      [](Scene& scene) { scene.agent.held = {"mug_1"}; }, {"held mug_1"}, {"held plate_1", "on mug_1 diningtable_1"}};
  all[Color] = {[](Scene& scene) { node(scene, "mug_1").color = "red"; }, {"colour mug_1 red"}, {"colour mug_1 blue"}};
  all[Material] = {
      [](Scene& scene) { node(scene, "mug_1").material = "glass"; }, {"material mug_1 glass"}, {"material mug_1 wood"}};
  all[On] = {moved("mug_1", 2.3, 1.35, 0.772), {"on mug_1 plate_1"}, {"on plate_1 mug_1", "inside mug_1 plate_1"}};
  all[Inside] = {moved("bulb_1", 2.2, 1.0, 0.76), {"inside bulb_1 mug_1"}, {"inside mug_1 bulb_1", "on bulb_1 mug_1"}};
  all[Under] = {moved("mug_1", 2.4, 1.2, 0),
                {"under mug_1 diningtable_1"},
                {"under diningtable_1 mug_1", "on mug_1 diningtable_1"}};
  all[NextTo] = {moved("bulb_1", 2.2, 1.12, 0.751),
                 {"next_to bulb_1 mug_1", "next_to mug_1 bulb_1"},
                 {"next_to bulb_1 fridge_1", "on bulb_1 mug_1"}};
  all[OnFloor] = {moved("mug_1", 1.2, 2.4, 0),
                  {"on_floor mug_1 kitchen_1"},
                  {"on_floor plate_1 kitchen_1", "on mug_1 diningtable_1"}};
  all[InRoom] = {[](Scene& scene) {
                   scene.rooms.push_back({"hall_1", "corridor", {{5, 0}, {8, 0}, {8, 4}, {5, 4}}});
                   scene.agent.position = {6.5, 2};
                 },
                 {"in_room agent hall_1", "in_room mug_1 kitchen_1"},
                 {"in_room agent kitchen_1", "in_room mug_1 hall_1"}};
  all[SliceOf] = {[](Scene& scene) {
                    node(scene, "potato_1").slice_of = "apple_1";
                    node(scene, "potato_1").whole_category = "Apple";
                  },
                  {"slice_of potato_1 apple_1"},
                  {"slice_of apple_1 potato_1"}};
  all[Attached] = {[](Scene& scene) {
                     moved("bulb_1", 0.35, 1.5, 1.001)(scene);
                     scene.edges.insert({On, "bulb_1", "lamp_1"});
                     scene.edges.insert({Attached, "bulb_1", "lamp_1"});
                   },
                   {"attached bulb_1 lamp_1", "on bulb_1 lamp_1"},
                   {"attached lamp_1 bulb_1"}};
  all[Nearest] = {[](Scene& scene) {
                    testing::add(scene, "mug_2", testing::kitchen_knowledge(scene.simulator), "Mug", 1.6, 3.4, 0.902);
                  },
                  {"nearest mug_2 countertop_1", "nearest mug_1 plate_1"},
                  {"nearest mug_1 countertop_1", "nearest mug_2 plate_1"}};
  return all;
}

/// Everything movable that is not held falls to where it rests.
Scene at_rest(Scene scene) {
  PhysicsWorld world = physics_of(scene);
  std::vector<BodyId> loose;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& thing = scene.nodes[i];
    if (thing.movable && scene.agent.held != std::vector<std::string>{thing.id}) loose.push_back(BodyId::node(i));
  }
  const Settled rest = world.settle(loose);
  EXPECT_TRUE(rest.calm);
  for (const SettledBody& body : rest.bodies) scene.nodes.edit(body.body.index()).pose = body.pose;
  return scene;
}

bool holds(const std::string& text, const Facts& facts, const EntityList& entities) {
  const auto words = split(text, ' ');
  const PredicateInfo& predicate = info(*predicate_named(words[0]));
  const auto entity = [&](const std::string& id) {
    const auto found = std::find_if(entities.begin(), entities.end(), [&](const Entity& e) { return e.id == id; });
    EXPECT_NE(found, entities.end()) << id;
    return EntityIndex(found - entities.begin());
  };
  if (predicate.arguments.size() == 1) return facts.holds(predicate.predicate, entity(words[1]));
  if (predicate.arguments[1] == ArgumentKind::Symbol)
    return facts.holds(predicate.predicate, entity(words[1]), std::string_view(words[2]));
  return facts.holds(predicate.predicate, entity(words[1]), entity(words[2]));
}

class PredicatePairs : public ::testing::TestWithParam<Simulator> {};

TEST_P(PredicatePairs, WhatIsSetReadsTrueAndItsReverseDoesNot) {
  const Knowledge knowledge = testing::kitchen_knowledge(GetParam());
  const Profile profile = *load_profile(UNIETP_SOURCE_DIR "/data/simulators", GetParam());
  const auto all = pairs();
  for (const PredicateInfo& predicate : all_predicates()) {
    SCOPED_TRACE(predicate.name);
    const auto found = all.find(predicate.predicate);
    ASSERT_NE(found, all.end()) << "a predicate without a pair";
    Scene scene = testing::wide_kitchen(GetParam());
    found->second.set(scene);
    // Through its file, physics and a world: what a reader of the data set would see.
    const auto read = scene_from_json("scene", scene_to_json(at_rest(scene)));
    ASSERT_TRUE(read) << format(read.error());
    const auto world = World::create(*read, knowledge, profile);
    ASSERT_TRUE(world) << format(world.error());
    FactReader reader(true);
    const Facts facts = reader.read(world->scene());
    const auto truth = [&](const std::string& text) { return holds(text, facts, reader.entities()); };
    for (const std::string& text : found->second.holds) EXPECT_TRUE(truth(text)) << text;
    for (const std::string& text : found->second.reverse) EXPECT_FALSE(truth(text)) << text;
  }
}

/// Beside one another means at one height: a box over or under another's side is not next to it.
TEST(NextTo, AsksForOverlappingHeights) {
  const auto beside_at = [](double z) {
    Scene scene;
    scene.rooms = {{"kitchen_1", "kitchen", {{0, 0}, {4, 0}, {4, 4}, {0, 4}}}};
    for (const auto& [id, position] : {std::pair("box_1", Vec3(1, 1, 0.1)), std::pair("box_2", Vec3(1.3, 1, z))}) {
      Node box;
      box.id = id;
      box.category = "Box";
      box.movable = true;
      box.size = {0.2, 0.2, 0.2};
      box.pose.position = position;
      scene.nodes.push_back(box);
    }
    const auto links = links_of(scene, physics_of(scene), 0);
    return std::any_of(links.begin(), links.end(), [](const Link& link) { return link.relation == Predicate::NextTo; });
  };
  EXPECT_TRUE(beside_at(0.1));
  EXPECT_TRUE(beside_at(0.25));
  EXPECT_FALSE(beside_at(0.35));
  EXPECT_FALSE(beside_at(1.5));
}

INSTANTIATE_TEST_SUITE_P(All, PredicatePairs, ::testing::ValuesIn(kSimulators),
                         [](const auto& simulator) { return std::string(name_of(simulator.param)); });

}  // namespace
}  // namespace unietp
