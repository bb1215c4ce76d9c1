// Cords, plugs and sockets: where they are drawn.
#include <algorithm>

#include <gtest/gtest.h>

#include "simulation/plug_solids.h"

namespace unietp {
namespace {

/// A room of 4 x 4 m.
Scene room() {
  Scene scene;
  scene.rooms.push_back({"kitchen_1", "kitchen", {{0, 0}, {4, 0}, {4, 4}, {0, 4}}});
  return scene;
}

/// A toaster on a counter of 0.9 m, or a fridge on the floor.
Node device(const Vec3& size, const Vec2& at, double low, Predicate state) {
  Node node;
  node.id = "device_1";
  node.size = size;
  node.states.set({state, ""});
  node.pose = upright(Vec3(at.x(), at.y(), low + size.z() / 2), 0);
  return node;
}
const Vec3 kToaster(0.3, 0.2, 0.2), kFridge(0.8, 0.7, 1.9), kWasher(0.6, 0.6, 0.86);

std::vector<Solid> plug_of(const Node& node, const Scene& scene) {
  std::vector<Solid> solids;
  add_plug_solids(node, 0, walls_of(scene), solids);
  return solids;
}
const Solid* socket_in(const std::vector<Solid>& solids) {
  const auto found =
      std::find_if(solids.begin(), solids.end(), [](const Solid& one) { return one.skin == Skin::Socket; });
  return found == solids.end() ? nullptr : &*found;
}
/// How far a solid stands out of a thing's box, along the axis where that is most, meters.
double out_of(const Node& node, const Solid& solid) {
  const Bounds box = bounds_of(node.pose, node.size), own = bounds_of(solid.pose, solid.size);
  return (own.high - box.high).cwiseMax(box.low - own.low).maxCoeff();
}

TEST(PlugSolids, BesideAWallHaveASocketInItAboveTheCups) {
  const Scene scene = room();
  const double face = 4 - scene.wall_thickness / 2;
  const Node toaster = device(kToaster, {2, face - 0.15}, 0.9, Predicate::PluggedIn);
  const std::vector<Solid> solids = plug_of(toaster, scene);
  const Solid* socket = socket_in(solids);
  ASSERT_NE(socket, nullptr);
  const Bounds plate = bounds_of(socket->pose, socket->size);
  EXPECT_NEAR(plate.high.y(), face, 1e-9) << "on the wall";
  EXPECT_LT(plate.high.y() - plate.low.y(), 0.01);
  EXPECT_GT(plate.low.z(), 0.9 + 0.14) << "above the cups on the counter";
  EXPECT_GT(plate.low.x(), 2 + kToaster.x() / 2) << "not behind the toaster";
  for (const Solid& solid : solids) EXPECT_LE(bounds_of(solid.pose, solid.size).high.y(), face + 1e-9);
}

TEST(PlugSolids, OfWhatIsTurnedOrInACornerAreInAWallThatGoesOn) {
  const Scene scene = room();
  const double face = 4 - scene.wall_thickness / 2;
  Node corner = device(kToaster, {face - 0.16, face - 0.15}, 0.9, Predicate::PluggedIn);
  const std::vector<Solid> solids = plug_of(corner, scene);
  ASSERT_NE(socket_in(solids), nullptr);
  for (const Solid& solid : solids) {
    const Bounds own = bounds_of(solid.pose, solid.size);
    EXPECT_LE(std::max(own.high.x(), own.high.y()), face + 1e-9) << "inside the room";
  }
  Node turned = device(kToaster, {2, face - 0.2}, 0.9, Predicate::PluggedIn);
  turned.pose = upright(turned.pose.position, 2.2);
  const std::vector<Solid> of_turned = plug_of(turned, scene);
  ASSERT_NE(socket_in(of_turned), nullptr);
  EXPECT_NEAR(bounds_of(socket_in(of_turned)->pose, socket_in(of_turned)->size).high.y(), face, 1e-9);
}

TEST(PlugSolids, AreNotInADoor) {
  Scene scene = room();
  scene.openings.push_back({});
  scene.openings.back().from = {1, 4};
  scene.openings.back().to = {3, 4};
  scene.openings.back().height = 2;
  const Node toaster = device(kToaster, {2, 3.75}, 0.9, Predicate::PluggedIn);
  for (const Solid& solid : plug_of(toaster, scene)) EXPECT_LE(out_of(toaster, solid), 0.05);
}

TEST(PlugSolids, WithoutAWallLieAlongTheThing) {
  const Scene scene = room();
  for (const Predicate state : {Predicate::PluggedIn, Predicate::Unplugged}) {
    const Node toaster = device(kToaster, {2, 2}, 0.9, state);
    const std::vector<Solid> solids = plug_of(toaster, scene);
    EXPECT_NE(socket_in(solids), nullptr);
    for (const Solid& solid : solids) {
      EXPECT_LE(out_of(toaster, solid), 0.0401);
      EXPECT_GE(bounds_of(solid.pose, solid.size).low.z(), 0.9 - 1e-9) << "on the table";
    }
  }
}

TEST(PlugSolids, OfWhatStandsOnTheFloorAreAboveCountersOrBeforeIt) {
  const Scene scene = room();
  const double face = 4 - scene.wall_thickness / 2;
  for (const Vec3& size : {kFridge, kWasher}) {
    const Node in = device(size, {2, face - size.y() / 2 - 0.02}, 0, Predicate::PluggedIn);
    const std::vector<Solid> solids = plug_of(in, scene);
    const Solid* socket = socket_in(solids);
    ASSERT_NE(socket, nullptr);
    EXPECT_GT(bounds_of(socket->pose, socket->size).low.z(), 1.0);
    const Node out = device(size, {2, 2}, 0, Predicate::Unplugged);
    for (const Solid& solid : plug_of(out, scene)) {
      const Bounds own = bounds_of(solid.pose, solid.size);
      EXPECT_GE(own.low.z(), -1e-9);
      EXPECT_LE(own.high.y(), 2 - size.y() / 2 + 1e-9) << "before it";
      EXPECT_GE(own.low.y(), 2 - size.y() / 2 - 0.15);
    }
  }
}

}  // namespace
}  // namespace unietp
