#include "simulation/world.h"
#include "simulation/feedback.h"

#include <gtest/gtest.h>

#include "simulation/relations.h"
#include "tests/simulation/kitchen.h"
#include "tests/simulation/kitchen_test.h"

namespace unietp {
namespace {

using testing::add;
using testing::kitchen;
using testing::kitchen_knowledge;
using testing::kitchen_profile;

class InTheKitchen : public testing::KitchenTest {
 protected:
  InTheKitchen() : KitchenTest(kitchen_knowledge(), kitchen_profile(), kitchen()) {}
  bool related(const World& world, Predicate relation, const char* a, const char* b) {
    return has_edge(world.scene(), relation, a, b);
  }
};

TEST_F(InTheKitchen, AMugIsCarriedIntoTheFridge) {
  World world = start();
  expect(world, ActionType::GoTo, "mug_1");
  expect(world, ActionType::PickUp, "mug_1");
  EXPECT_FALSE(related(world, Predicate::On, "mug_1", "diningtable_1"));
  expect(world, ActionType::GoTo, "fridge_1");
  expect_failure(world, ActionType::PlaceIn, "fridge_1", Failure::ReceptacleClosed);
  expect(world, ActionType::Open, "fridge_1");
  expect(world, ActionType::PlaceIn, "fridge_1");
  EXPECT_TRUE(related(world, Predicate::Inside, "mug_1", "fridge_1"));
  EXPECT_TRUE(world.scene().agent.held.empty());
  expect(world, ActionType::Close, "fridge_1");
  EXPECT_TRUE(is(world, "mug_1", Predicate::Cool));
  EXPECT_EQ(world.closed_around("mug_1"), "fridge_1");
  expect_failure(world, ActionType::PickUp, "mug_1", Failure::InsideClosed);
}

TEST_F(InTheKitchen, WhatIsInTheHandIsAtNoPlaceNotEvenInARoom) {
  World world = start();
  ASSERT_TRUE(has_edge(world.scene(), Predicate::InRoom, "mug_1", "kitchen_1"));
  expect(world, ActionType::GoTo, "mug_1");
  expect(world, ActionType::PickUp, "mug_1");
  for (const Edge& edge : world.scene().edges) EXPECT_TRUE(edge.from != "mug_1" && edge.to != "mug_1");
  expect(world, ActionType::GoTo, "countertop_1");
  expect(world, ActionType::PlaceOn, "countertop_1");
  EXPECT_TRUE(has_edge(world.scene(), Predicate::InRoom, "mug_1", "kitchen_1"));
}

TEST_F(InTheKitchen, WhatIsFarOrHiddenIsOutOfReach) {
  World world = start();
  expect_failure(world, ActionType::PickUp, "potato_1", Failure::TooFar);
  expect_failure(world, ActionType::Open, "fridge_1", Failure::TooFar);
  expect_failure(world, ActionType::PickUp, "nothing_7", Failure::InvalidArgument);
  expect_failure(world, ActionType::PickUp, "", Failure::InvalidArgument);
  expect_failure(world, ActionType::PlaceOn, "diningtable_1", Failure::NotHolding);
  expect_failure(world, ActionType::UseUp, "mug_1", Failure::NotConsumable);
}

TEST_F(InTheKitchen, AHandHoldsOneThingAndOnlyWhatCanBeHeld) {
  World world = start();
  expect(world, ActionType::GoTo, "mug_1");
  expect(world, ActionType::PickUp, "mug_1");
  expect_failure(world, ActionType::PickUp, "apple_1", Failure::HandsFull);
  expect_failure(world, ActionType::PickUp, "diningtable_1", Failure::NotPickupable);
}

TEST_F(InTheKitchen, APlateIsCarriedWithWhatLiesOnIt) {
  World world = start();
  expect(world, ActionType::GoTo, "potato_1");
  expect(world, ActionType::PickUp, "potato_1");
  expect(world, ActionType::PlaceOn, "plate_1");
  EXPECT_TRUE(related(world, Predicate::On, "potato_1", "plate_1"));
  expect(world, ActionType::PickUp, "plate_1");
  EXPECT_TRUE(related(world, Predicate::On, "potato_1", "plate_1"));
  expect(world, ActionType::GoTo, "countertop_1");
  expect(world, ActionType::PlaceOn, "countertop_1");
  EXPECT_TRUE(related(world, Predicate::On, "plate_1", "countertop_1"));
  EXPECT_TRUE(related(world, Predicate::On, "potato_1", "plate_1"));
  EXPECT_FALSE(related(world, Predicate::On, "potato_1", "countertop_1"));
}

TEST_F(InTheKitchen, ADrawerCarriesItsContents) {
  World world = start();
  expect(world, ActionType::GoTo, "knife_1");
  expect(world, ActionType::PickUp, "knife_1");
  expect(world, ActionType::GoTo, "dresser_1");
  expect(world, ActionType::Open, "dresser_1");
  expect(world, ActionType::PlaceIn, "dresser_1");
  const double open_x = find_node(world.scene(), "knife_1")->pose.position.x();
  expect(world, ActionType::Close, "dresser_1");
  EXPECT_TRUE(related(world, Predicate::Inside, "knife_1", "dresser_1"));
  EXPECT_LT(find_node(world.scene(), "knife_1")->pose.position.x(), open_x - 0.2);
}

TEST_F(InTheKitchen, ACompositeActionDoesWhatItStandsFor) {
  World world = start();
  expect(world, ActionType::GoTo, "potato_1");
  expect(world, ActionType::PickUp, "potato_1");
  expect_failure(world, ActionType::HeatWith, "microwave_1", Failure::TooFar);
  expect(world, ActionType::GoTo, "microwave_1");
  expect_failure(world, ActionType::CoolWith, "microwave_1", Failure::NoEffect);
  expect(world, ActionType::HeatWith, "microwave_1");
  EXPECT_TRUE(is(world, "potato_1", Predicate::Hot));
  EXPECT_EQ(world.scene().agent.held, std::vector<std::string>{"potato_1"});
  EXPECT_TRUE(is(world, "microwave_1", Predicate::PowerOff));
  EXPECT_TRUE(is(world, "microwave_1", Predicate::Closed));
}

TEST_F(InTheKitchen, NothingFixedIsCarriedByAHandThatIsHeldUnderIt) {
  World world = start();
  expect(world, ActionType::GoTo, "mug_1");
  expect(world, ActionType::PickUp, "mug_1");
  Scene scene = world.scene();
  scene.edges.insert({Predicate::On, "microwave_1", "mug_1"});  // as poses can say of a hand before a microwave
  World again = start(std::move(scene));
  expect(again, ActionType::GoTo, "microwave_1");
  expect(again, ActionType::Open, "microwave_1");
  EXPECT_TRUE(is(again, "microwave_1", Predicate::Open));
  EXPECT_EQ(again.scene().agent.held, std::vector<std::string>{"mug_1"});
}

TEST_F(InTheKitchen, WhatIsCooledIsPutWhereTheHandCanTakeItBack) {
  World world = start();
  expect(world, ActionType::GoTo, "mug_1");
  expect(world, ActionType::PickUp, "mug_1");
  expect(world, ActionType::GoTo, "fridge_1");
  expect(world, ActionType::CoolWith, "fridge_1");
  EXPECT_TRUE(is(world, "mug_1", Predicate::Cool));
  EXPECT_EQ(world.scene().agent.held, std::vector<std::string>{"mug_1"});
}

TEST_F(InTheKitchen, WhatIsPutIntoADeepBasinLiesWhereTheHandCanTakeItBack) {
  Scene scene = testing::kitchen();
  edit_node(scene, "sink_1")->size = {0.7, 0.7, 1.1};  // its near wall hides what lies behind it
  edit_node(scene, "sink_1")->pose.position.z() = 0.55;
  World world = start(scene);
  expect(world, ActionType::GoTo, "knife_1");
  expect(world, ActionType::PickUp, "knife_1");
  expect(world, ActionType::GoTo, "sink_1");
  expect(world, ActionType::PlaceIn, "sink_1");
  EXPECT_TRUE(has_edge(world.scene(), Predicate::Inside, "knife_1", "sink_1"));
  expect(world, ActionType::PickUp, "knife_1");
}

TEST_F(InTheKitchen, AMicrowaveRunsOnlyShutAndDoesNotOpenWhileItRuns) {
  World world = start();
  expect(world, ActionType::GoTo, "microwave_1");
  expect(world, ActionType::Open, "microwave_1");
  expect_failure(world, ActionType::TurnOn, "microwave_1", Failure::MustBeClosed);
  expect(world, ActionType::Close, "microwave_1");
  expect(world, ActionType::TurnOn, "microwave_1");
  expect_failure(world, ActionType::Open, "microwave_1", Failure::AlreadyOn);
  expect_failure(world, ActionType::TurnOn, "microwave_1", Failure::AlreadyOn);
}

TEST_F(InTheKitchen, TheSinkWashesADirtyMug) {
  Scene scene = kitchen();
  edit_node(scene, "mug_1")->states.set({Predicate::Dirty, ""});
  World world = start(scene);
  expect(world, ActionType::GoTo, "mug_1");
  expect(world, ActionType::PickUp, "mug_1");
  expect(world, ActionType::GoTo, "sink_1");
  expect(world, ActionType::WashWith, "sink_1");
  EXPECT_TRUE(is(world, "mug_1", Predicate::Clean));
  EXPECT_FALSE(is(world, "mug_1", Predicate::Dirty));
}

TEST_F(InTheKitchen, SlicingMakesBodiesThatLieWhereTheWholeLay) {
  World world = start();
  expect(world, ActionType::GoTo, "apple_1");
  expect_failure(world, ActionType::Slice, "apple_1", Failure::NoKnife);
  expect(world, ActionType::PickUp, "knife_1");
  expect_failure(world, ActionType::Slice, "potato_1", Failure::NotSliceable);
  const double mass = find_node(world.scene(), "apple_1")->mass;
  expect(world, ActionType::Slice, "apple_1");
  EXPECT_TRUE(is(world, "apple_1", Predicate::Sliced));
  double total = find_node(world.scene(), "apple_1")->mass;
  int pieces = 0;
  for (const Node& node : world.scene().nodes) {
    if (node.slice_of != "apple_1") continue;
    ++pieces;
    total += node.mass;
    EXPECT_TRUE(related(world, Predicate::On, node.id.c_str(), "diningtable_1")) << node.id;
  }
  EXPECT_EQ(pieces, 3);
  EXPECT_NEAR(total, mass, 1e-12);
  expect_failure(world, ActionType::Slice, "apple_1", Failure::NotSliceable);
}

TEST_F(InTheKitchen, ADoorThatWouldHitSomethingStaysShut) {
  Scene scene = kitchen();
  add(scene, "countertop_2", knowledge_, "CounterTop", 4.2, 2.5, 0);  // in the fridge door's way
  scene.edges = read_relations(scene);
  World world = start(scene);
  expect(world, ActionType::GoTo, "fridge_1");
  expect_failure(world, ActionType::Open, "fridge_1", Failure::Blocked);
}

TEST_F(InTheKitchen, AFullReceptacleHasNoFreePlace) {
  Scene scene = kitchen();
  edit_node(scene, "plate_1")->size = {0.12, 0.12, 0.02};
  World world = start(scene);
  expect(world, ActionType::GoTo, "potato_1");
  expect(world, ActionType::PickUp, "potato_1");
  expect(world, ActionType::PlaceOn, "plate_1");
  expect(world, ActionType::PickUp, "mug_1");
  expect_failure(world, ActionType::PlaceOn, "plate_1", Failure::NoFreePlace);
}

TEST_F(InTheKitchen, EdgesAfterEveryStepAreThoseThatAFreshReadingGives) {
  World world = start();
  const std::vector<std::pair<ActionType, const char*>> plan{
      {ActionType::GoTo, "mug_1"},           {ActionType::PickUp, "mug_1"},   {ActionType::GoTo, "countertop_1"},
      {ActionType::PlaceOn, "countertop_1"}, {ActionType::GoTo, "fridge_1"},  {ActionType::Open, "fridge_1"},
      {ActionType::GoTo, "plate_1"},         {ActionType::PickUp, "plate_1"}, {ActionType::GoTo, "sink_1"},
      {ActionType::PlaceIn, "sink_1"}};
  for (const auto& [type, id] : plan) {
    expect(world, type, id);
    if (world.scene().agent.held.empty()) {
      EXPECT_EQ(world.scene().edges, read_relations(world.scene())) << id;
    }
  }
}

TEST_F(InTheKitchen, EqualActionsGiveEqualScenesAndCopiesAreIndependent) {
  World first = start(), second = start();
  expect(first, ActionType::GoTo, "apple_1");
  expect(second, ActionType::GoTo, "apple_1");
  expect(first, ActionType::PickUp, "apple_1");
  const World before = first;
  expect(second, ActionType::PickUp, "apple_1");
  EXPECT_TRUE(first.scene() == second.scene());
  expect(first, ActionType::PlaceOn, "diningtable_1");
  EXPECT_EQ(before.scene().agent.held.size(), 1u);
  EXPECT_TRUE(first.scene().agent.held.empty());
}

TEST_F(InTheKitchen, TheCameraListsWhatItSeesAndNotWhatADoorHides) {
  Scene scene = kitchen();
  add(scene, "mug_2", knowledge_, "Mug", 4.4, 3.6, 0.022);
  scene.edges = read_relations(scene);
  ASSERT_TRUE(has_edge(scene, Predicate::Inside, "mug_2", "fridge_1"));
  World world = start(scene);
  const auto sees = [&](const char* id) {
    const auto visible = world.visible();
    return std::any_of(visible.begin(), visible.end(), [&](const VisibleObject& v) { return v.id == id; });
  };
  expect(world, ActionType::GoTo, "mug_2");  // goes to the fridge that hides it
  EXPECT_TRUE(sees("fridge_1"));
  EXPECT_FALSE(sees("mug_2"));
  expect(world, ActionType::Open, "fridge_1");
  expect(world, ActionType::GoTo, "mug_2");  // a step back, to see under the shelf
  EXPECT_TRUE(sees("mug_2"));
  EXPECT_FALSE(sees("microwave_1"));  // behind the agent
  for (const VisibleObject& v : world.visible()) {
    EXPECT_LE(v.box[0], v.box[2]);
    EXPECT_LE(v.box[1], v.box[3]);
    EXPECT_GE(v.box[0], 0);
    EXPECT_LT(v.box[2], profile_.image_width);
  }
}

TEST_F(InTheKitchen, NothingHappensAfterStop) {
  World world = start();
  expect(world, ActionType::Stop);
  EXPECT_TRUE(world.stopped());
  expect_failure(world, ActionType::GoTo, "mug_1", Failure::InvalidAction);
}

}  // namespace
}  // namespace unietp
