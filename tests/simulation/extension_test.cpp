// What only the profile `wide` offers: sitting, lying, plugs, folding, breaking, attaching.
#include <gtest/gtest.h>

#include "simulation/feedback.h"
#include "simulation/world.h"
#include "tests/simulation/kitchen.h"
#include "tests/simulation/kitchen_test.h"

namespace unietp {
namespace {

class Wide : public testing::KitchenTest {
 protected:
  explicit Wide(Simulator simulator)
      : KitchenTest(testing::kitchen_knowledge(simulator), testing::kitchen_profile(simulator, ActionProfile::Wide),
                    testing::wide_kitchen(simulator)) {}
};

class WideVirtualhome : public Wide {
 protected:
  WideVirtualhome() : Wide(Simulator::Virtualhome) {}
};
class WideBehavior : public Wide {
 protected:
  WideBehavior() : Wide(Simulator::Behavior) {}
};
class WideAi2thor : public Wide {
 protected:
  WideAi2thor() : Wide(Simulator::Ai2thor) {}
};

TEST_F(WideVirtualhome, WhoSitsKeepsTheSeatUntilStandingUp) {
  World world = start();
  expect_failure(world, ActionType::SitOn, "sofa_1", Failure::TooFar);
  expect_failure(world, ActionType::SitOn, "fridge_1", Failure::NotASeat);
  expect_failure(world, ActionType::StandUp, "", Failure::NotSeated);
  expect(world, ActionType::GoTo, "sofa_1");
  expect(world, ActionType::SitOn, "sofa_1");
  EXPECT_TRUE(is(world, "sofa_1", Predicate::SatOn));
  expect_failure(world, ActionType::SitOn, "sofa_1", Failure::Seated);
  expect_failure(world, ActionType::LieOn, "sofa_1", Failure::Seated);
  expect_failure(world, ActionType::MoveForward, "", Failure::Seated);
  expect_failure(world, ActionType::TurnLeft, "", Failure::Seated);
  expect_failure(world, ActionType::GoTo, "mug_1", Failure::Seated);
  expect(world, ActionType::StandUp);
  EXPECT_FALSE(is(world, "sofa_1", Predicate::SatOn));
  expect(world, ActionType::LieOn, "sofa_1");
  EXPECT_TRUE(is(world, "sofa_1", Predicate::LainOn));
  expect(world, ActionType::StandUp);
  expect(world, ActionType::GoTo, "mug_1");
}

TEST_F(WideVirtualhome, ASofaFullOfThingsHasNoPlaceToLie) {
  for (int i = 0; i < 3; ++i)
    testing::add(scene_, "towel_" + std::to_string(i + 2), knowledge_, "Towel", 4.15, 0.7 + 0.5 * i, 0.402);
  World world = start();
  expect(world, ActionType::GoTo, "sofa_1");
  expect_failure(world, ActionType::LieOn, "sofa_1", Failure::NoFreePlace);
  expect(world, ActionType::SitOn, "sofa_1");
}

TEST_F(WideVirtualhome, ALampRunsOnlyPluggedIn) {
  World world = start();
  expect(world, ActionType::GoTo, "fridge_1");
  expect_failure(world, ActionType::PlugIn, "lamp_1", Failure::TooFar);
  expect_failure(world, ActionType::PlugIn, "mug_1", Failure::NotPluggable);
  expect(world, ActionType::GoTo, "lamp_1");
  expect_failure(world, ActionType::TurnOn, "lamp_1", Failure::NotPluggedIn);
  expect_failure(world, ActionType::Unplug, "lamp_1", Failure::AlreadyUnplugged);
  expect(world, ActionType::PlugIn, "lamp_1");
  expect_failure(world, ActionType::PlugIn, "lamp_1", Failure::AlreadyPluggedIn);
  expect(world, ActionType::TurnOn, "lamp_1");
  expect(world, ActionType::Unplug, "lamp_1");
  EXPECT_TRUE(is(world, "lamp_1", Predicate::Unplugged));
  EXPECT_TRUE(is(world, "lamp_1", Predicate::PowerOff));
}

TEST_F(WideBehavior, ATowelIsFoldedWithAFreeHandAndNothingOnIt) {
  World world = start();
  expect(world, ActionType::GoTo, "fridge_1");
  expect_failure(world, ActionType::Fold, "towel_1", Failure::TooFar);
  expect_failure(world, ActionType::Fold, "mug_1", Failure::NotFoldable);
  expect(world, ActionType::GoTo, "bulb_1");
  expect(world, ActionType::PickUp, "bulb_1");
  expect(world, ActionType::GoTo, "towel_1");
  expect_failure(world, ActionType::Fold, "towel_1", Failure::HandsFull);
  expect(world, ActionType::PlaceOn, "towel_1");
  expect_failure(world, ActionType::Fold, "towel_1", Failure::Blocked);
  expect(world, ActionType::PickUp, "bulb_1");
  expect(world, ActionType::PlaceOn, "countertop_1");
  expect(world, ActionType::Fold, "towel_1");
  EXPECT_TRUE(is(world, "towel_1", Predicate::Folded));
  expect_failure(world, ActionType::Fold, "towel_1", Failure::AlreadyFolded);
}

TEST_F(WideBehavior, ABulbStaysAttachedToItsLampUntilItIsTaken) {
  World world = start();
  expect(world, ActionType::GoTo, "bulb_1");
  expect(world, ActionType::PickUp, "bulb_1");
  expect(world, ActionType::GoTo, "lamp_1");
  expect(world, ActionType::PlaceOn, "lamp_1");
  const auto attached = [](const World& w) { return has_edge(w.scene(), Predicate::Attached, "bulb_1", "lamp_1"); };
  EXPECT_TRUE(attached(world));
  EXPECT_TRUE(has_edge(world.scene(), Predicate::On, "bulb_1", "lamp_1"));
  expect(world, ActionType::GoTo, "fridge_1");
  expect(world, ActionType::Open, "fridge_1");
  EXPECT_TRUE(attached(world));
  EXPECT_TRUE(attached(*World::create(world.scene(), knowledge_, profile_)));
  expect(world, ActionType::GoTo, "bulb_1");
  expect(world, ActionType::PickUp, "bulb_1");
  EXPECT_FALSE(attached(world));
}

TEST_F(WideBehavior, NothingAttachesWithoutTheWideProfile) {
  profile_ = testing::kitchen_profile(Simulator::Behavior);
  World world = start();
  expect_failure(world, ActionType::Fold, "towel_1", Failure::NotOffered);
  expect(world, ActionType::GoTo, "bulb_1");
  expect(world, ActionType::PickUp, "bulb_1");
  expect(world, ActionType::GoTo, "lamp_1");
  expect_failure(world, ActionType::PlaceOn, "lamp_1", Failure::NotAReceptacle);
}

TEST_F(WideAi2thor, ABrokenMugHoldsNothing) {
  edit_node(scene_, "mug_1")->states.set({Predicate::Filled, "water"});
  World world = start();
  expect(world, ActionType::GoTo, "fridge_1");
  expect_failure(world, ActionType::Break, "mug_1", Failure::TooFar);
  expect_failure(world, ActionType::Break, "plate_1", Failure::NotBreakable);
  expect_failure(world, ActionType::MoveHandLeft, "", Failure::NotOffered);
  expect(world, ActionType::GoTo, "mug_1");
  expect(world, ActionType::PickUp, "mug_1");
  expect_failure(world, ActionType::Break, "mug_1", Failure::InvalidArgument);
  expect(world, ActionType::PlaceOn, "diningtable_1");
  expect(world, ActionType::Break, "mug_1");
  EXPECT_TRUE(is(world, "mug_1", Predicate::Broken));
  EXPECT_TRUE(is(world, "mug_1", Predicate::Empty));
  expect_failure(world, ActionType::Break, "mug_1", Failure::AlreadyBroken);
}

}  // namespace
}  // namespace unietp
