#include "scene/scene.h"

#include <set>

#include <gtest/gtest.h>

#include <vector>

#include <algorithm>

#include "random_scene.h"
#include "scene/fresh_id.h"
#include "scene/room_finder.h"
#include "scene/telling_order.h"

namespace unietp {
namespace {

Scene with_nodes(const std::vector<std::string>& ids) {
  Scene scene;
  for (const std::string& id : ids) scene.nodes.emplace_back().id = id;
  return scene;
}

TEST(FreshId, IsTheCategoryInSnakeCaseAndTheSmallestFreeNumber) {
  EXPECT_EQ(fresh_id({}, "Mug"), "mug_1");
  EXPECT_EQ(fresh_id(with_nodes({"mug_1", "mug_3"}), "Mug"), "mug_2");
  EXPECT_EQ(fresh_id(with_nodes({"mug_1", "mug_2", "mug_01", "mug_x", "mug_99999999999999999999"}), "Mug"), "mug_3");
  EXPECT_EQ(fresh_id({}, "CoffeeMachine"), "coffee_machine_1");
  EXPECT_EQ(fresh_id({}, "TVStand"), "tv_stand_1");
  EXPECT_EQ(fresh_id({}, "wine glass"), "wine_glass_1");
  EXPECT_EQ(fresh_id({}, "coffee_table.n.01"), "coffee_table_1");
  EXPECT_EQ(fresh_id({}, "2DPoster"), "2_d_poster_1");
  EXPECT_EQ(fresh_id({}, "?"), "object_1");
}

TEST(DrawnId, IsDrawnByTheNamesAndNeverTaken) {
  Scene scene;
  scene.id = "home-1";
  std::vector<std::string> ids;
  for (int i = 0; i < 120; ++i) {  // so many that numbers above 99 are needed
    ids.push_back(drawn_id(scene, NodeIndex(scene.nodes), "Mug"));
    EXPECT_EQ(find_node(scene, ids.back()), nullptr);
    EXPECT_EQ(ids.back(), drawn_id(scene, NodeIndex(scene.nodes), "Mug"));
    Node& node = scene.nodes.emplace_back();
    node.id = ids.back(), node.category = "Mug";
  }
  EXPECT_FALSE(std::is_sorted(ids.begin(), ids.end()));
  const NodeIndex before(scene.nodes);
  Scene other;
  other.id = "home-1";
  EXPECT_EQ(drawn_id(other, NodeIndex(other.nodes), "Mug"), ids[0]);
  EXPECT_FALSE(before.find(drawn_id(other, NodeIndex(other.nodes), "Mug", &before)));
  other.id = "home-2";
  EXPECT_NE(drawn_id(other, NodeIndex(other.nodes), "Mug"), ids[0]);
}

TEST(DrawnId, IsFoundWhereOtherCategoriesTookAllSmallNumbers) {
  std::vector<std::string> taken;
  for (int i = 1; i <= 99; ++i) taken.push_back("wine_glass_" + std::to_string(i));
  const Scene scene = with_nodes(taken);
  const std::string id = drawn_id(scene, NodeIndex(scene.nodes), "WineGlass");
  EXPECT_TRUE(id.starts_with("wine_glass_"));
  EXPECT_EQ(find_node(scene, id), nullptr);
}

TEST(TellingOrder, IsByRoomAndSaysNothingOfTheOrderInTheScene) {
  Scene scene = with_nodes({"mug_1", "cup_2", "pan_3", "fork_4", "plate_5", "bowl_6", "in_no_room_7"});
  scene.id = "home";
  scene.rooms = {{"kitchen_1", "kitchen", {}}, {"bedroom_2", "bedroom", {}}};
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < 6; ++i)
    edges.push_back({Predicate::InRoom, scene.nodes[i].id, i % 2 == 0 ? "kitchen_1" : "bedroom_2"});
  scene.edges = EdgeSet(edges);
  const auto told = [](const Scene& one) {
    std::vector<std::string> ids;
    for (const Node& node : in_telling_order(one).nodes) ids.push_back(node.id);
    return ids;
  };
  const auto order = told(scene);
  EXPECT_EQ(order.back(), "in_no_room_7");
  EXPECT_EQ(order.size(), scene.nodes.size());
  EXPECT_EQ(in_telling_order(scene).rooms.size(), scene.rooms.size());
  const auto in_kitchen = [](const std::string& id) { return id == "mug_1" || id == "pan_3" || id == "plate_5"; };
  EXPECT_TRUE(std::is_partitioned(order.begin(), order.begin() + 6, in_kitchen) ||
              std::is_partitioned(order.rend() - 6, order.rend(), in_kitchen));
  Scene turned = scene;
  std::vector<Node> nodes(scene.nodes.begin(), scene.nodes.end());
  std::reverse(nodes.begin(), nodes.end());
  turned.nodes = SharedList<Node>(nodes);
  std::swap(turned.rooms[0], turned.rooms[1]);
  EXPECT_EQ(told(turned), order);
  erase_if(turned.nodes, [](const Node& node) { return node.id == "pan_3"; });
  auto less = order;
  std::erase(less, "pan_3");
  EXPECT_EQ(told(turned), less);
  std::set<std::vector<std::string>> orders;
  for (int i = 0; i < 20; ++i) {
    scene.id = "home-" + std::to_string(i);
    orders.insert(told(scene));
  }
  EXPECT_GT(orders.size(), 10U);
}

TEST(FreshId, IsNotTakenByARoom) {
  Scene scene;
  scene.rooms.push_back({"kitchen_1", "kitchen", {}});
  EXPECT_EQ(fresh_id(scene, "kitchen"), "kitchen_2");
}

TEST(FreshId, IsNewForAnySeed) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Rng rng(seed);
    Scene scene;
    for (std::uint64_t i = rng.below(30); i > 0; --i) {
      const std::string id = "cup_" + std::to_string(rng.below(30));
      if (!find_node(scene, id)) scene.nodes.emplace_back().id = id;
    }
    const std::string id = fresh_id(scene, "Cup");
    EXPECT_EQ(find_node(scene, id), nullptr);
    for (int n = 1; "cup_" + std::to_string(n) != id; ++n) {
      EXPECT_NE(find_node(scene, "cup_" + std::to_string(n)), nullptr) << seed;
    }
  }
}

TEST(Scenes, FindWhatTheyHoldAndNothingElseForAnySeed) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Scene scene = random_scene(rng);
    for (const Node& node : scene.nodes) EXPECT_EQ(find_node(scene, node.id), &node);
    for (const Room& room : scene.rooms) EXPECT_EQ(find_room(scene, room.id), &room);
    EXPECT_EQ(find_node(scene, "nothing"), nullptr);
    EXPECT_EQ(find_room(scene, "nowhere"), nullptr);
    const std::set<Edge> edges(scene.edges.begin(), scene.edges.end());
    for (const Node& from : scene.nodes) {
      for (const Node& to : scene.nodes) {
        EXPECT_EQ(has_edge(scene, Predicate::On, from.id, to.id), edges.contains({Predicate::On, from.id, to.id}));
      }
    }
  }
}

TEST(Scenes, TellTheRoomOfAPoint) {
  Scene scene;
  scene.rooms = {{"a", "hall", {{0, 0}, {2, 0}, {2, 2}, {0, 2}}}, {"b", "hall", {{2, 0}, {4, 0}, {4, 2}, {2, 2}}}};
  EXPECT_EQ(room_at(scene, {1, 1}), &scene.rooms[0]);
  EXPECT_EQ(room_at(scene, {3, 1}), &scene.rooms[1]);
  EXPECT_NE(room_at(scene, {2, 1}), nullptr);
  EXPECT_EQ(room_at(scene, {5, 1}), nullptr);
}

TEST(Scenes, TheRoomsOfManyPointsAreThoseOfEach) {
  Scene scene;
  scene.rooms = {{"corner", "hall", {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}},  // an L, and one in its bend
                 {"bend", "kitchen", {{1, 1}, {4, 1}, {4, 4}, {1, 4}}},
                 {"slope", "attic", {{4, 0}, {6, 2}, {4, 4}}}};
  const RoomFinder finder(scene.rooms);
  for (double x = -0.5; x <= 6.5; x += 0.125) {
    for (double y = -0.5; y <= 4.5; y += 0.125) {
      const Room* room = room_at(scene, {x, y});
      const auto found = finder.at({x, y});
      ASSERT_EQ(found ? &scene.rooms[*found] : nullptr, room) << x << " " << y;
    }
  }
  EXPECT_FALSE(RoomFinder().at({0, 0}));
}

TEST(Scenes, TheRoomsOfPointsInAStreetAreThoseOfEach) {
  Scene scene;
  Rng rng(3);
  for (int i = 0; i < 60; ++i) {
    const double x = 3.0 * i, wide = rng.uniform(1, 3), deep = rng.uniform(1, 3);
    scene.rooms.push_back({"room_" + std::to_string(i), "hall", {{x, 2}, {x + wide, 2}, {x + wide, 2 + deep}, {x, 2}}});
    if (i == 30) scene.rooms.push_back({"street", "corridor", {{0, 0}, {180, 0}, {180, 2}, {0, 2}}});
  }
  const RoomFinder finder(scene.rooms);
  for (int i = 0; i < 4000; ++i) {
    const Vec2 point(rng.uniform(-5, 185), rng.uniform(-1, 6));
    const Room* room = room_at(scene, point);
    const auto found = finder.at(point);
    ASSERT_EQ(found ? &scene.rooms[*found] : nullptr, room) << point.transpose();
  }
}

TEST(Names, OfSimulatorsAndArchetypesLeadBack) {
  for (const Simulator simulator : kSimulators) EXPECT_EQ(simulator_named(name_of(simulator)), simulator);
  EXPECT_EQ(simulator_named("gazebo"), std::nullopt);
  std::set<std::string_view> names;
  for (const Archetype archetype : all_archetypes()) {
    EXPECT_EQ(archetype_named(name_of(archetype)), archetype);
    names.insert(name_of(archetype));
  }
  EXPECT_EQ(names.size(), all_archetypes().size());
  EXPECT_EQ(name_of(Archetype::Block), "block");
  EXPECT_EQ(name_of(Archetype::Box), "box");
  EXPECT_EQ(name_of(Archetype::Folding), "folding");
  EXPECT_EQ(archetype_named("tesseract"), std::nullopt);
}

}  // namespace
}  // namespace unietp
