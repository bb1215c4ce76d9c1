#include "symbolic/perform.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/kitchen_knowledge.h"

namespace unietp::symbolic {
namespace {

/// The kitchen's knowledge with places for five of each movable thing.
Knowledge kitchen_with_places(Simulator simulator) {
  const auto bare = testing::kitchen_knowledge(simulator);
  std::vector<Placement> placements;
  for (const auto& object : bare.categories()) {
    if (!object.movable) continue;
    placements.push_back({object.name, Predicate::On, "CounterTop", 0.5, 5, object.source});
    for (const char* container : {"Fridge", "Microwave", "Sink", "Mug"})
      placements.push_back({object.name, Predicate::Inside, container, 0.1, 5, object.source});
  }
  return {simulator, bare.categories(), bare.affordances(), placements, bare.effects(), {}};
}

/// A kitchen without geometry: a counter, a fridge, a microwave, a sink, a knife on the counter, an apple in the
/// fridge, a dirty mug in the sink. The agent stands in the hall.
struct Kitchen {
  Knowledge knowledge;
  Rules rules;
  Setting setting;
  World world;
  Id counter, fridge, microwave, sink, knife, apple, mug;

  explicit Kitchen(Simulator simulator = Simulator::Ai2thor)
      : knowledge(kitchen_with_places(simulator)),
        rules(knowledge, capabilities_of(simulator),
              {"CounterTop", "Fridge", "Microwave", "Sink", "Knife", "Apple", "Mug"}) {
    setting.rules = &rules;
    setting.objects.rooms = {{"kitchen_1", "Kitchen"}, {"hall_1", "Hall"}};
    counter = add("CounterTop");
    fridge = add("Fridge");
    microwave = add("Microwave");
    sink = add("Sink");
    knife = add("Knife", PlaceKind::On, counter);
    apple = add("Apple", PlaceKind::Inside, fridge);
    mug = add("Mug", PlaceKind::Inside, sink);
    world[mug].set(Predicate::Dirty);
    world.room = Id::room(1);
    add_pieces(setting, world);
  }

  Id add(const std::string& category, PlaceKind where = PlaceKind::Floor, Id at = Id::room(0)) {
    ObjectEntry role;
    role.id = category;
    role.kind = rules.kind_named(category).value();
    setting.objects.things.push_back(role);
    Thing thing = default_thing(rules.kind(role.kind));
    thing.where = where;
    thing.at = at;
    world.things.push_back(thing);
    return Id::thing(world.things.size() - 1);
  }

  Failure act(ActionType action, Id target = kNobody) { return perform(setting, world, {action, target}); }
  bool is(Id id, Predicate state) const { return holds(setting, world, state, id, kNobody, kAnySymbol); }
};

using enum ActionType;

TEST(Perform, WhatIsFarOrShutAwayIsOutOfReach) {
  Kitchen home;
  EXPECT_EQ(home.act(Open, home.fridge), Failure::TooFar);
  EXPECT_EQ(home.act(GoTo, home.apple), Failure::None);
  EXPECT_EQ(home.world.room, Id::room(0));
  EXPECT_EQ(home.act(PickUp, home.apple), Failure::InsideClosed);
  EXPECT_EQ(home.act(Open, home.fridge), Failure::None);
  EXPECT_EQ(home.act(Open, home.fridge), Failure::AlreadyOpen);
  EXPECT_EQ(home.act(PickUp, home.apple), Failure::None);
  EXPECT_EQ(home.act(PickUp, home.knife), Failure::HandsFull);
  EXPECT_TRUE(home.is(home.apple, Predicate::Held));
}

/// Of the things of one category, the one whose furniture stands nearest to that of another thing.
TEST(Nearest, IsTheOneAtTheLeastDistance) {
  Kitchen home;
  double spot = 0;
  for (const Id furniture : {home.counter, home.fridge, home.microwave, home.sink})
    home.setting.objects.object(furniture).spot_m = 2 * spot++;
  const Id cold = home.add("Mug", PlaceKind::On, home.fridge);  // at 2 m; the other, in the sink, at 6 m
  const auto nearest = [&](Id thing, Id other) {
    return holds(home.setting, home.world, Predicate::Nearest, thing, other, kAnySymbol);
  };
  EXPECT_TRUE(nearest(cold, home.counter));
  EXPECT_FALSE(nearest(home.mug, home.counter));
  EXPECT_TRUE(nearest(home.mug, home.sink));
  EXPECT_FALSE(nearest(cold, home.sink));
  EXPECT_TRUE(nearest(home.apple, home.sink)) << "the only one of its category";
}

TEST(Perform, AFailedActionChangesNothing) {
  Kitchen home;
  const World before = home.world;
  for (const ActionInfo& action : all_actions()) {
    for (std::size_t i = 0; i < home.world.things.size(); ++i) {
      const Id id = Id::thing(i);
      World trial = before;
      if (perform(home.setting, trial, {action.type, id}) == Failure::None) continue;
      EXPECT_EQ(trial, before) << action.name;
    }
  }
}

TEST(Perform, AMicrowaveIsShutToRunAndStaysShutWhileItRuns) {
  Kitchen home;
  home.act(GoTo, home.microwave);
  EXPECT_EQ(home.act(TurnOn, home.microwave), Failure::None);
  EXPECT_EQ(home.act(Open, home.microwave), Failure::AlreadyOn);
  EXPECT_EQ(home.act(TurnOff, home.microwave), Failure::None);
  EXPECT_EQ(home.act(Open, home.microwave), Failure::None);
  EXPECT_EQ(home.act(TurnOff, home.microwave), Failure::AlreadyOff);
}

TEST(Perform, CompositeActionsLeaveToolsAsTheyWereAndTheThingInHand) {
  Kitchen home;
  home.act(GoTo, home.mug);
  ASSERT_EQ(home.act(PickUp, home.mug), Failure::None);
  ASSERT_EQ(home.act(HeatWith, home.microwave), Failure::TooFar);
  home.act(GoTo, home.microwave);
  const Thing before = home.world[home.microwave];
  ASSERT_EQ(home.act(HeatWith, home.microwave), Failure::None);
  EXPECT_EQ(home.world[home.microwave], before);
  EXPECT_TRUE(home.is(home.mug, Predicate::Hot));
  EXPECT_TRUE(home.is(home.mug, Predicate::Held));
  EXPECT_EQ(home.act(WashWith, home.microwave), Failure::NoEffect);
}

TEST(Perform, AThingThatIsShutInAnApplianceThatIsTurnedOnIsTreated) {
  Kitchen home;
  home.act(GoTo, home.mug);
  home.act(PickUp, home.mug);
  home.act(GoTo, home.microwave);
  EXPECT_EQ(home.act(PlaceIn, home.microwave), Failure::ReceptacleClosed);
  home.act(Open, home.microwave);
  ASSERT_EQ(home.act(PlaceIn, home.microwave), Failure::None);
  home.act(Close, home.microwave);
  EXPECT_FALSE(home.is(home.mug, Predicate::Hot));
  ASSERT_EQ(home.act(TurnOn, home.microwave), Failure::None);
  EXPECT_TRUE(home.is(home.mug, Predicate::Hot));
}

TEST(Perform, SlicingMakesPiecesWhereTheWholeIsAndKeepsTheWhole) {
  Kitchen home;
  home.act(GoTo, home.fridge);
  home.act(Open, home.fridge);
  EXPECT_EQ(home.act(Slice, home.apple), Failure::NoKnife);
  home.act(GoTo, home.counter);
  home.act(PickUp, home.knife);
  home.act(GoTo, home.fridge);
  ASSERT_EQ(home.act(Slice, home.apple), Failure::None);
  EXPECT_TRUE(home.is(home.apple, Predicate::Sliced));
  const auto trace = trace_of(home.setting, {home.world});
  EXPECT_EQ(std::count_if(trace.entities.begin(), trace.entities.end(),
                          [](const Entity& entity) { return entity.slice_of == "Apple"; }),
            3);
  const Id piece = Id::thing(home.mug.index() + 1);
  EXPECT_TRUE(holds(home.setting, home.world, Predicate::Inside, piece, home.fridge, kAnySymbol));
  EXPECT_EQ(home.act(Slice, home.apple), Failure::NotSliceable);
}

TEST(Perform, WhatFitsIsWhatTheKnowledgeSays) {
  Kitchen home;
  home.act(GoTo, home.mug);
  home.act(PickUp, home.mug);
  EXPECT_EQ(home.act(PlaceOn, home.fridge), Failure::TooFar);
  home.act(GoTo, home.fridge);
  EXPECT_EQ(home.act(PlaceOn, home.fridge), Failure::DoesNotFit);
  for (int i = 0; i < 5; ++i) home.add("Mug", PlaceKind::On, home.counter);
  home.act(GoTo, home.counter);
  EXPECT_EQ(home.act(PlaceOn, home.counter), Failure::NoFreePlace);  // five fit, and five are there
}

TEST(Perform, NothingIsDoneThatTheSimulatorDoesNotOffer) {
  Kitchen home(Simulator::Virtualhome);
  home.act(GoTo, home.mug);
  ASSERT_EQ(home.act(PickUp, home.mug), Failure::None);
  EXPECT_EQ(home.act(Drop), Failure::NotOffered);
  home.act(GoTo, home.sink);
  EXPECT_EQ(home.act(WashWith, home.sink), Failure::NotOffered);
}

TEST(Perform, AThingInAThingThatIsCarriedGoesAlong) {
  Kitchen home;
  home.world[home.knife].where = PlaceKind::Inside;
  home.world[home.knife].at = home.mug;
  home.act(GoTo, home.sink);
  ASSERT_EQ(home.act(PickUp, home.mug), Failure::None);
  home.act(GoTo, home.counter);
  ASSERT_EQ(home.act(PlaceOn, home.counter), Failure::None);
  EXPECT_TRUE(holds(home.setting, home.world, Predicate::Inside, home.knife, home.mug, kAnySymbol));
  EXPECT_EQ(root_of(home.world, home.knife), home.counter);
}

}  // namespace
}  // namespace unietp::symbolic
