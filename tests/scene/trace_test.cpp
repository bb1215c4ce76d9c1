#include "scene/trace.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "random_scene.h"

namespace unietp {
namespace {

EntityIndex index_of(const EntityList& entities, std::string_view id) {
  for (EntityIndex i; i.index() < entities.size(); ++i) {
    if (entities[i].id == id) return i;
  }
  return EntityIndex(entities.size());
}

TEST(Delta, AppliedToTheSceneBeforeGivesTheSceneAfterForAnySeed) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Scene before = random_scene(rng);
    const Scene after = random_successor(before, rng);
    const Delta delta = difference(before, after);
    EXPECT_EQ(apply(before, delta), after);
    EXPECT_EQ(delta.empty(), before == after);
    EXPECT_TRUE(difference(before, before).empty());
  }
}

TEST(Delta, HoldsOnlyWhatChanged) {
  Rng rng(1);
  Scene before;
  for (const char* id : {"a", "b", "c", "d"}) before.nodes.push_back(random_node(id, rng));
  Scene after = before;
  after.nodes.edit(1).opening = 0.25;
  erase_if(after.nodes, [](const Node& node) { return node.id == "c"; });
  after.nodes.push_back(random_node("e", rng));
  const Delta delta = difference(before, after);
  ASSERT_EQ(delta.nodes.size(), 2u);
  EXPECT_EQ(delta.nodes[0], after.nodes[1]);
  EXPECT_EQ(delta.nodes[1].id, "e");
  EXPECT_EQ(delta.removed, std::vector<std::string>{"c"});
  EXPECT_FALSE(delta.agent);
}

TEST(Facts, OfASceneAreItsNodesStatesAndEdgesAndNothingElseForAnySeed) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    FactReader reader;
    Scene scene = random_scene(rng);
    for (int step = 0; step < 3; ++step, scene = random_successor(scene, rng)) {
      const Facts facts = reader.read(scene);
      const auto& entities = reader.entities();
      for (EntityIndex x; x.index() < entities.size(); ++x) {
        const std::string& id = entities[x].id;
        const Node* node = find_node(scene, id);
        EXPECT_EQ(facts.exists(x), id == "agent" || find_room(scene, id) || node) << id;
        const bool held = node && std::count(scene.agent.held.begin(), scene.agent.held.end(), id) > 0;
        EXPECT_EQ(facts.holds(Predicate::Held, x), held);
        EXPECT_EQ(facts.holds(Predicate::Hot, x), node && node->states.has(Predicate::Hot));
        EXPECT_EQ(facts.holds(Predicate::Covered, x, "dust"),
                  node && node->states.has(State{Predicate::Covered, "dust"}));
        EXPECT_EQ(facts.holds(Predicate::Filled, x, "any"), node && node->states.has(Predicate::Filled));
        EXPECT_EQ(facts.holds(Predicate::Color, x, "red"), node && node->color == "red");
        EXPECT_EQ(facts.holds(Predicate::Material, x, "any"), node && !node->material.empty());
        for (EntityIndex y; y.index() < entities.size(); ++y) {
          for (const Predicate p : {Predicate::On, Predicate::InRoom, Predicate::OnFloor}) {
            EXPECT_EQ(facts.holds(p, x, y), has_edge(scene, p, id, entities[y].id));
          }
          EXPECT_FALSE(facts.holds(Predicate::Nearest, x, y));
        }
      }
    }
  }
}

TEST(Facts, EntitiesAreTheAgentTheRoomsThenTheNodesInOrderOfAppearanceAndKeepTheirPlaces) {
  Rng rng(3);
  Scene scene;
  scene.rooms.push_back({"kitchen_1", "kitchen", {{0, 0}, {1, 0}, {1, 1}}});
  scene.nodes = {random_node("z", rng), random_node("a", rng)};
  FactReader reader;
  reader.read(scene);
  scene.nodes = {random_node("m", rng), random_node("a", rng)};
  scene.nodes.edit(0).category = "BreadSliced", scene.nodes.edit(0).slice_of = "a",
  scene.nodes.edit(0).whole_category = "Bread";
  const Facts facts = reader.read(scene);
  std::vector<std::string> ids;
  for (const Entity& entity : reader.entities()) ids.push_back(entity.id);
  EXPECT_EQ(ids, (std::vector<std::string>{"agent", "kitchen_1", "z", "a", "m"}));
  EXPECT_EQ(reader.entities()[0], (Entity{Entity::Kind::Agent, "agent", "agent", ""}));
  EXPECT_EQ(reader.entities()[1], (Entity{Entity::Kind::Room, "kitchen_1", "kitchen", ""}));
  EXPECT_EQ(reader.entities()[4], (Entity{Entity::Kind::Object, "m", "BreadSliced", "Bread"}));
  EXPECT_FALSE(facts.exists(EntityIndex(2)));
  EXPECT_TRUE(facts.holds(Predicate::SliceOf, EntityIndex(4), EntityIndex(3)));
}

TEST(Facts, NearestIsTheOneThatEveryOtherOfItsCategoryIsClearlyFurtherThanForAnySeed) {
  int clear = 0, unclear = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    Scene scene = random_scene(rng);
    const bool alike = seed % 2 == 1;  // many of one category, along a street
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
      Node& node = scene.nodes.edit(i);  // a grid, so that ties are common
      node.pose.position = {static_cast<double>(rng.below(alike ? 60 : 4)), static_cast<double>(rng.below(4)), 0};
      if (alike) node.category = "Mug";
    }
    FactReader reader(true);
    const Facts facts = reader.read(scene);
    for (const Node& y : scene.nodes) {
      for (const Node& x : scene.nodes) {
        const double own = (x.pose.position - y.pose.position).norm();
        bool nearest = x.id != y.id;
        for (const Node& other : scene.nodes) {
          if (other.id == x.id || other.id == y.id || other.category != x.category) continue;
          const double more = (other.pose.position - y.pose.position).norm() - own;
          nearest = nearest && more >= 0.25 && more >= 0.2 * own;
        }
        const auto& entities = reader.entities();
        EXPECT_EQ(facts.holds(Predicate::Nearest, index_of(entities, x.id), index_of(entities, y.id)), nearest);
        (nearest ? clear : unclear) += 1;
      }
    }
  }
  EXPECT_GT(clear, 100);
  EXPECT_GT(unclear, 100);
}

TEST(Facts, SizeTellsTheOneThatIsClearlyLargerOrSmallerThanAllOthersOfItsCategory) {
  const auto sized = [](const std::string& id, const std::string& category, double height) {
    Node node;
    node.id = id;
    node.category = category;
    node.size = Vec3(0.1, 0.1, height);
    return node;
  };
  const auto size_of = [](const SharedList<Node>& nodes, const std::string& id) -> std::string {
    Scene scene;
    scene.nodes = nodes;
    FactReader reader(true);
    const Facts facts = reader.read(scene);
    const auto index = index_of(reader.entities(), id);
    const bool large = facts.holds(Predicate::Size, index, "large");
    return large ? "large" : facts.holds(Predicate::Size, index, "small") ? "small" : "";
  };
  const auto small = sized("a", "Mug", 0.1), middle = sized("b", "Mug", 0.14), other = sized("c", "Plate", 0.5);
  EXPECT_EQ(size_of({small, middle, other}, "a"), "small");
  EXPECT_EQ(size_of({small, middle, other}, "b"), "large");
  EXPECT_EQ(size_of({small, middle, other}, "c"), "") << "there is no second plate to compare with";
  const auto nearly = sized("d", "Mug", 0.15);
  EXPECT_EQ(size_of({small, middle, nearly}, "d"), "") << "one and a half times one, but not 1.3 times the other";
  EXPECT_EQ(size_of({small, middle, nearly}, "a"), "small");
}

TEST(ToLogic, ReadsTheSameStatesAsReadingEachSceneInTurn) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Scene start = random_scene(rng);
    FactReader reader;
    std::vector<Facts> states{reader.read(start)};
    std::vector<Delta> deltas;
    Scene scene = start;
    for (int step = 0; step < 5; ++step) {
      const Scene next = random_successor(scene, rng);
      deltas.push_back(difference(scene, next));
      states.push_back(reader.read(next));
      scene = next;
    }
    const Trace trace = to_logic(start, deltas);
    EXPECT_EQ(trace.entities, reader.entities());
    EXPECT_EQ(trace.states, states);
  }
}

}  // namespace
}  // namespace unietp
