// Actions of the body and the hand, and on what things hold or are covered with.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "simulation/feedback.h"
#include "simulation/world.h"
#include "tests/simulation/kitchen.h"
#include "tests/simulation/kitchen_test.h"

namespace unietp {
namespace {

class Acting : public testing::KitchenTest {
 protected:
  explicit Acting(Simulator simulator)
      : KitchenTest(testing::kitchen_knowledge(simulator), testing::kitchen_profile(simulator),
                    testing::full_kitchen(simulator)) {}
  void take(World& world, const std::string& id) {
    expect(world, ActionType::GoTo, id);
    expect(world, ActionType::PickUp, id);
  }
};

class InAi2thor : public Acting {
 protected:
  InAi2thor() : Acting(Simulator::Ai2thor) {}
};
class InBehavior : public Acting {
 protected:
  InBehavior() : Acting(Simulator::Behavior) {}
};
class InHabitat : public Acting {
 protected:
  InHabitat() : Acting(Simulator::Habitat) {}
};

TEST_F(InAi2thor, FourStepsAroundASquareEndWhereTheyBegan) {
  World world = start();
  const Agent before = world.scene().agent;
  expect(world, ActionType::MoveForward);
  EXPECT_NEAR((world.scene().agent.position - before.position).norm(), profile_.step_m, 1e-12);
  expect(world, ActionType::MoveLeft);
  expect(world, ActionType::MoveBackward);
  expect(world, ActionType::MoveRight);
  EXPECT_NEAR((world.scene().agent.position - before.position).norm(), 0, 1e-12);
  for (int i = 0; i < 12; ++i) expect(world, ActionType::TurnLeft);
  EXPECT_NEAR(world.scene().agent.yaw, before.yaw, 1e-9) << "twelve turns of 30 degrees";
  expect(world, ActionType::TurnRight);
  EXPECT_NEAR(world.scene().agent.yaw, before.yaw - std::numbers::pi / 6, 1e-9);
}

TEST_F(InAi2thor, TheBodyStopsAtFurnitureAndWalls) {
  World world = start();  // looks along +x from (1.5, 2.3)
  expect(world, ActionType::TurnLeft);
  expect(world, ActionType::TurnLeft);
  expect(world, ActionType::TurnLeft);  // toward the counter
  int steps = 0;
  while (steps < 20 && world.step({ActionType::MoveForward, {}}).success) ++steps;
  EXPECT_LT(world.scene().agent.position.y(), 3.3 - profile_.body_radius_m + 1e-9);
  expect_failure(world, ActionType::MoveForward, "", Failure::Blocked);
  EXPECT_GT(steps, 1);
}

TEST_F(InAi2thor, TheCameraTiltsWithinItsLimits) {
  World world = start();
  expect(world, ActionType::LookUp);
  expect_failure(world, ActionType::LookUp, "", Failure::Blocked);
  for (int i = 0; i < 3; ++i) expect(world, ActionType::LookDown);
  EXPECT_NEAR(world.scene().agent.pitch, std::numbers::pi / 3, 1e-9);
  expect_failure(world, ActionType::LookDown, "", Failure::Blocked);
  expect_failure(world, ActionType::ResetHead, "", Failure::NotOffered);
}

TEST_F(InHabitat, TheHeadIsLevelAgainAfterAReset) {
  World world = start();
  expect(world, ActionType::LookDown);
  expect(world, ActionType::ResetHead);
  EXPECT_EQ(world.scene().agent.pitch, 0);
  expect(world, ActionType::TurnBaseToLook);
  expect_failure(world, ActionType::MoveHandForward, "", Failure::NotOffered);
}

TEST_F(InAi2thor, TheHandMovesWhatItHoldsUntilSomethingIsInTheWay) {
  World world = start();
  expect_failure(world, ActionType::MoveHandForward, "", Failure::NotHolding);
  take(world, "mug_1");
  const auto ahead = [&] {
    const Agent& agent = world.scene().agent;
    const Vec2 way = find_node(world.scene(), "mug_1")->pose.position.head<2>() - agent.position;
    return way.dot(Vec2(std::cos(agent.yaw), std::sin(agent.yaw)));
  };
  const double before = ahead();
  expect(world, ActionType::MoveHandForward);
  EXPECT_NEAR(ahead(), before + 0.2, 1e-9);
  expect(world, ActionType::MoveHandForward);
  expect_failure(world, ActionType::MoveHandForward, "", Failure::Blocked);
  expect(world, ActionType::MoveHandBackward);
  expect(world, ActionType::MoveHandLeft);
  expect(world, ActionType::MoveHandRight);
  EXPECT_NEAR(ahead(), before + 0.2, 1e-9);
  const Quat held = find_node(world.scene(), "mug_1")->pose.rotation;
  expect(world, ActionType::RotateHand);
  EXPECT_NEAR(held.angularDistance(find_node(world.scene(), "mug_1")->pose.rotation), std::numbers::pi / 6, 1e-9);
}

TEST_F(InAi2thor, AHandThatWouldPushItsMugIntoTheFridgeStaysWhereItIs) {
  World world = start();
  take(world, "mug_1");
  expect(world, ActionType::GoTo, "fridge_1");
  int moves = 0;
  ActionResult last;
  do {
    last = world.step({ActionType::MoveHandForward, {}});
    ++moves;
  } while (last.success && moves < 10);
  EXPECT_EQ(last.failure, Failure::Blocked);
  for (int i = 0; i < 10 && world.step({ActionType::MoveForward, {}}).success; ++i) {
  }
}

TEST_F(InAi2thor, WhatIsDroppedFallsToTheFloor) {
  World world = start();
  expect_failure(world, ActionType::Drop, "", Failure::NotHolding);
  take(world, "potato_1");
  expect(world, ActionType::GoTo, "kitchen_1");
  for (int i = 0; i < 6; ++i) expect(world, ActionType::TurnLeft);  // away from the table
  expect(world, ActionType::Drop);
  EXPECT_TRUE(world.scene().agent.held.empty());
  EXPECT_TRUE(has_edge(world.scene(), Predicate::OnFloor, "potato_1", "kitchen_1"));
  take(world, "potato_1");
}

TEST_F(InAi2thor, APlateIsDroppedWithWhatLiesOnIt) {
  World world = start();
  take(world, "potato_1");
  expect(world, ActionType::PlaceOn, "plate_1");
  expect(world, ActionType::PickUp, "plate_1");
  expect(world, ActionType::GoTo, "kitchen_1");
  for (int i = 0; i < 6; ++i) expect(world, ActionType::TurnLeft);  // away from the table
  expect(world, ActionType::Drop);
  EXPECT_TRUE(has_edge(world.scene(), Predicate::OnFloor, "plate_1", "kitchen_1"));
  EXPECT_NE(room_at(world.scene(), find_node(world.scene(), "potato_1")->pose.position.head<2>()), nullptr);
}

TEST_F(InAi2thor, WineIsPouredIntoAnEmptyMugAndWaterDownTheDrain) {
  World world = start();
  take(world, "winebottle_1");
  expect_failure(world, ActionType::PourTo, "mug_1", Failure::TooFar);
  expect(world, ActionType::GoTo, "mug_1");
  expect_failure(world, ActionType::PourTo, "plate_1", Failure::NotFillable);
  expect(world, ActionType::PourTo, "mug_1");
  EXPECT_TRUE(is(world, "mug_1", Predicate::Filled, "wine"));
  EXPECT_TRUE(is(world, "winebottle_1", Predicate::Empty));
  expect_failure(world, ActionType::PourTo, "mug_1", Failure::VesselEmpty);
  expect(world, ActionType::PlaceOn, "diningtable_1");
  expect_failure(world, ActionType::PourTo, "sink_1", Failure::NotHolding);
  expect(world, ActionType::PickUp, "mug_1");
  expect(world, ActionType::GoTo, "sink_1");
  expect(world, ActionType::PourTo, "sink_1");
  EXPECT_TRUE(is(world, "mug_1", Predicate::Empty));
  EXPECT_FALSE(find_node(world.scene(), "sink_1")->states.has(Predicate::Filled)) << "a drain stays empty";
}

TEST_F(InAi2thor, AFullMugTakesNoMore) {
  Scene scene = scene_;
  edit_node(scene, "mug_1")->states.set({Predicate::Filled, "water"});
  World world = start(scene);
  take(world, "winebottle_1");
  expect(world, ActionType::GoTo, "mug_1");
  expect_failure(world, ActionType::PourTo, "mug_1", Failure::AlreadyFull);
}

TEST_F(InAi2thor, ATapFillsWhatIsHeldUnderIt) {
  World world = start();
  take(world, "mug_1");
  expect(world, ActionType::GoTo, "sink_1");
  expect(world, ActionType::FillWith, "sink_1");
  EXPECT_TRUE(is(world, "mug_1", Predicate::Filled, "water"));
  EXPECT_EQ(world.scene().agent.held, std::vector<std::string>{"mug_1"});
  expect(world, ActionType::GoTo, "winebottle_1");
  expect_failure(world, ActionType::FillWith, "winebottle_1", Failure::NoEffect);
}

TEST_F(InAi2thor, SoapIsUsedUpOnce) {
  World world = start();
  expect_failure(world, ActionType::UseUp, "mug_1", Failure::NotConsumable);
  expect(world, ActionType::GoTo, "dresser_1");
  expect_failure(world, ActionType::UseUp, "soapbar_1", Failure::TooFar);
  expect(world, ActionType::GoTo, "soapbar_1");
  expect(world, ActionType::UseUp, "soapbar_1");
  EXPECT_TRUE(is(world, "soapbar_1", Predicate::UsedUp));
  expect_failure(world, ActionType::UseUp, "soapbar_1", Failure::NotConsumable);
}

TEST_F(InAi2thor, APotatoIsCookedInTheMicrowave) {
  World world = start();
  take(world, "potato_1");
  expect(world, ActionType::GoTo, "microwave_1");
  expect(world, ActionType::CookWith, "microwave_1");
  EXPECT_TRUE(is(world, "potato_1", Predicate::Cooked));
  EXPECT_TRUE(is(world, "potato_1", Predicate::Hot));
  expect_failure(world, ActionType::BurnWith, "stove_1", Failure::NotOffered);
}

TEST_F(InBehavior, AFlameBurnsWhatIsHeldToIt) {
  World world = start();
  take(world, "potato_1");
  expect(world, ActionType::GoTo, "stove_1");
  expect(world, ActionType::BurnWith, "stove_1");
  EXPECT_TRUE(is(world, "potato_1", Predicate::Burnt));
  EXPECT_TRUE(is(world, "stove_1", Predicate::PowerOff)) << "and is put out again";
}

TEST_F(InBehavior, AStainWantsAWetTowelAndDustADryOne) {
  Scene scene = scene_;
  edit_node(scene, "plate_1")->states.set({Predicate::Dirty, ""});
  edit_node(scene, "plate_1")->states.set({Predicate::Covered, "dust"});
  World world = start(scene);
  expect(world, ActionType::GoTo, "plate_1");
  expect_failure(world, ActionType::Wipe, "plate_1", Failure::NotHolding);
  take(world, "towel_1");
  expect(world, ActionType::GoTo, "plate_1");
  expect_failure(world, ActionType::Wipe, "plate_1", Failure::NotReady);
  expect_failure(world, ActionType::Wipe, "mug_1", Failure::NoEffect);
  expect(world, ActionType::GoTo, "sink_1");
  expect(world, ActionType::SoakWith, "sink_1");
  EXPECT_TRUE(is(world, "towel_1", Predicate::Soaked));
  expect(world, ActionType::GoTo, "plate_1");
  expect(world, ActionType::Wipe, "plate_1");
  EXPECT_TRUE(is(world, "plate_1", Predicate::Clean));
  EXPECT_FALSE(find_node(world.scene(), "plate_1")->states.has(Predicate::Covered));
}

TEST_F(InBehavior, DustAloneComesOffDry) {
  Scene scene = scene_;
  edit_node(scene, "plate_1")->states.set({Predicate::Covered, "dust"});
  World world = start(scene);
  take(world, "towel_1");
  expect(world, ActionType::GoTo, "plate_1");
  expect(world, ActionType::Wipe, "plate_1");
  EXPECT_FALSE(find_node(world.scene(), "plate_1")->states.has(Predicate::Covered));
}

TEST_F(InBehavior, KetchupCoversAPlateAndTheSinkWashesItOff) {
  World world = start();
  take(world, "ketchup_1");
  expect(world, ActionType::GoTo, "plate_1");
  expect_failure(world, ActionType::SpreadTo, "mug_1", Failure::NoEffect);
  expect(world, ActionType::SpreadTo, "plate_1");
  EXPECT_TRUE(is(world, "plate_1", Predicate::Covered, "ketchup"));
  expect(world, ActionType::PlaceOn, "diningtable_1");
  expect(world, ActionType::PickUp, "plate_1");
  expect(world, ActionType::GoTo, "sink_1");
  expect(world, ActionType::WashWith, "sink_1");
  EXPECT_FALSE(find_node(world.scene(), "plate_1")->states.has(Predicate::Covered));
}

}  // namespace
}  // namespace unietp
