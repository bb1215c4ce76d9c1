#include "simulation/physics.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "logic/entity_list.h"
#include "scene/node_index.h"
#include "simulation/relations.h"
#include "tests/simulation/kitchen.h"

namespace unietp {
namespace {

using testing::add;
using testing::kitchen;
using testing::kitchen_knowledge;

std::size_t index_of(const Scene& scene, std::string_view id) {
  return static_cast<std::size_t>(NodeIndex(scene.nodes).find(id).value());
}

/// Drops one object and reads what it came to.
Scene dropped(Scene scene, const std::string& id) {
  PhysicsWorld world = physics_of(scene);
  const BodyId loose[] = {BodyId::node(index_of(scene, id))};
  const Settled settled = world.settle(loose);
  EXPECT_TRUE(settled.calm);
  edit_node(scene, id)->pose = settled.bodies.front().pose;
  scene.edges = read_relations(scene);
  return scene;
}

TEST(Settle, WhatIsLetGoAboveATableComesToRestOnIt) {
  Scene scene = kitchen();
  add(scene, "mug_2", kitchen_knowledge(), "Mug", 2.9, 0.95, 0.85);
  const Scene after = dropped(scene, "mug_2");
  EXPECT_TRUE(has_edge(after, Predicate::On, "mug_2", "diningtable_1"));
  EXPECT_NEAR(find_node(after, "mug_2")->pose.position.z(), 0.75 + 0.05, 0.002);
}

TEST(Settle, WhatIsLetGoBesideTheTableFallsToTheFloor) {
  Scene scene = kitchen();
  add(scene, "mug_2", kitchen_knowledge(), "Mug", 4.0, 1.2, 0.85);
  const Scene after = dropped(scene, "mug_2");
  EXPECT_FALSE(has_edge(after, Predicate::On, "mug_2", "diningtable_1"));
  EXPECT_TRUE(has_edge(after, Predicate::OnFloor, "mug_2", "kitchen_1"));
}

TEST(Settle, WhatHangsOverTheEdgeTopplesOff) {
  Scene scene = kitchen();
  add(scene, "plate_2", kitchen_knowledge(), "Plate", 3.1 + 0.07, 1.0, 0.76);  // its middle is 7 cm past the edge
  EXPECT_TRUE(has_edge(dropped(scene, "plate_2"), Predicate::OnFloor, "plate_2", "kitchen_1"));
}

TEST(Settle, AStackStandsAndEachIsOnTheNextBelowOnly) {
  Scene scene = kitchen();
  add(scene, "plate_2", kitchen_knowledge(), "Plate", 2.3, 1.35, 0.78);
  const Scene after = dropped(scene, "plate_2");
  EXPECT_TRUE(has_edge(after, Predicate::On, "plate_2", "plate_1"));
  EXPECT_FALSE(has_edge(after, Predicate::On, "plate_2", "diningtable_1"));
}

TEST(Settle, AFridgeHoldsWhatIsInItAndAMugWhatIsInIt) {
  Scene scene = kitchen();
  const Knowledge knowledge = kitchen_knowledge();
  add(scene, "mug_2", knowledge, "Mug", 4.4, 3.6, 0.03);
  Scene after = dropped(scene, "mug_2");
  EXPECT_TRUE(has_edge(after, Predicate::Inside, "mug_2", "fridge_1"));
  EXPECT_FALSE(has_edge(after, Predicate::On, "mug_2", "fridge_1"));
  Node& pea = add(after, "potato_2", knowledge, "Potato", 0, 0, 0);
  pea.size = Vec3(0.04, 0.04, 0.04);
  pea.pose.position = find_node(after, "mug_2")->pose.position + Vec3(0, 0, 0.03);
  after = dropped(after, "potato_2");
  EXPECT_TRUE(has_edge(after, Predicate::Inside, "potato_2", "mug_2"));
  EXPECT_TRUE(has_edge(after, Predicate::Inside, "potato_2", "fridge_1"));  // and so in the fridge as well
}

TEST(Settle, GivesTheSameBitsEachTime) {
  Scene scene = kitchen();
  add(scene, "apple_2", kitchen_knowledge(), "Apple", 2.6, 1.2, 1.2);
  const PhysicsWorld world = physics_of(scene);
  const BodyId loose[] = {BodyId::node(index_of(scene, "apple_2")), BodyId::node(index_of(scene, "mug_1"))};
  const Settled first = world.settle(loose), second = PhysicsWorld(world).settle(loose);
  ASSERT_EQ(first.bodies.size(), second.bodies.size());
  for (std::size_t i = 0; i < first.bodies.size(); ++i) EXPECT_TRUE(first.bodies[i].pose == second.bodies[i].pose);
}

TEST(Overlap, NamesWhatStandsThereAndNothingWhenFree) {
  const Scene scene = kitchen();
  const PhysicsWorld world = physics_of(scene);
  const Shape mug = make_shape(Archetype::Vessel, {0.09, 0.09, 0.1}, false);
  const auto hit = world.overlap(mug, upright({2.2, 1.0, 0.81}, 0), 0, {});
  ASSERT_TRUE(hit);
  EXPECT_EQ(scene.nodes[hit->index()].id, "mug_1");
  EXPECT_FALSE(world.overlap(mug, upright({2.2, 1.0, 1.2}, 0), 0, {}));
}

static_assert(!std::is_convertible_v<std::size_t, BodyId> && !std::is_convertible_v<BodyId, std::size_t>);
static_assert(!std::is_convertible_v<EntityIndex, BodyId> && !std::is_constructible_v<EntityIndex, BodyId>);

TEST(BodyId, NodesWallsAndTheFloorAreToldApartInAnyNumber) {
  const auto node = BodyId::node(1'000'000), wall = BodyId::wall(1'000'000);
  EXPECT_TRUE(node.is_node() && !node.is_wall());
  EXPECT_TRUE(wall.is_wall() && !wall.is_node());
  EXPECT_FALSE(kFloor.is_node() || kFloor.is_wall());
  EXPECT_TRUE(node < BodyId::wall(0) && wall < kFloor);
  EXPECT_EQ(node.index(), wall.index());
  EXPECT_THROW(BodyId::node(std::size_t{1} << 31), std::length_error);
}

TEST(Ray, MeetsWallsAndClosedDoorsFirst) {
  const Scene scene = kitchen();
  const PhysicsWorld world = physics_of(scene);
  const auto wall = world.ray({2.5, 2, 1.5}, {2.5, -3, 1.5});
  ASSERT_TRUE(wall);
  EXPECT_TRUE(wall->body.is_wall());
  const auto door = world.ray({4.4, 2, 1.0}, {4.4, 3.6, 1.0});
  ASSERT_TRUE(door);
  EXPECT_EQ(scene.nodes[door->body.index()].id, "fridge_1");
}

TEST(ReadRelations, OnlyThoseOfWhatIsNearAChangeAreOthersAfterIt) {
  Scene scene = kitchen();
  PhysicsWorld world = physics_of(scene);
  std::vector<std::vector<Link>> before;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) before.push_back(links_of(scene, world, i));
  const std::size_t mug = index_of(scene, "mug_1");
  const Bounds was = world.bounds(BodyId::node(mug));
  scene.nodes.edit(mug).pose = upright({1.2, 3.55, 0.9505}, 0.3);
  world.move(BodyId::node(mug), scene.nodes[mug].pose);
  const Bounds touched[] = {was, world.bounds(BodyId::node(mug))};
  const std::size_t changed[] = {mug};
  const auto affected = affected_by(world, touched, changed);
  EXPECT_LT(affected.size(), scene.nodes.size());
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (std::binary_search(affected.begin(), affected.end(), i)) continue;
    EXPECT_TRUE(links_of(scene, world, i) == before[i]) << scene.nodes[i].id;
  }
  EXPECT_NE(read_relations(scene), scene.edges);
}

}  // namespace
}  // namespace unietp
