// What demonstrations do that a careful person would not, in plans written by hand.
#include "validator/carefulness.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/expert/house.h"

namespace unietp::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::UnorderedElementsAre;

struct Careful : ::testing::Test {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  Scene start = at_rest(house());

  Carelessness of(const std::string& text, const std::vector<Action>& plan) const {
    World done = *World::create(start, knowledge, profile);
    for (const Action& action : plan) EXPECT_TRUE(done.step(action).success) << to_text(action);
    return carelessness_of(goal(text), *World::create(start, knowledge, profile), TraceMaker(start, false, false),
                           plan);
  }
};

constexpr const char* kMugOnTable = "(exists (?x - Mug) (exists (?y - SideTable) (at-end (on ?x ?y))))";
constexpr const char* kHot = "(exists (?x - Potato) (at-end (hot ?x)))";

std::vector<Action> operator+(std::vector<Action> first, const std::vector<Action>& then) {
  first.insert(first.end(), then.begin(), then.end());
  return first;
}
std::vector<Action> fetch(const char* id) { return {{ActionType::GoTo, {id}}, {ActionType::PickUp, {id}}}; }
std::vector<Action> put_on(const char* id) { return {{ActionType::GoTo, {id}}, {ActionType::PlaceOn, {id}}}; }

TEST_F(Careful, NothingIsAmissInAPlanThatDoesWhatIsAsked) {
  EXPECT_THAT(of(kMugOnTable, fetch("mug_1") + put_on("sidetable_1")), IsEmpty());
}

TEST_F(Careful, WhatIsParkedAndWhatIsLeftElsewhereIsFound) {
  const auto plan = fetch("mug_1") + put_on("diningtable_1") + fetch("apple_1") + put_on("countertop_1") +
                    fetch("mug_1") + put_on("sidetable_1");
  EXPECT_THAT(of(kMugOnTable, plan), UnorderedElementsAre(Pair(CarelessKind::Parked, ElementsAre("mug_1")),
                                                          Pair(CarelessKind::Moved, ElementsAre("apple_1")),
                                                          Pair(CarelessKind::MovedFreely, ElementsAre("apple_1"))));
}

TEST_F(Careful, WhatIsLeftOpenIsFoundUnlessTheGoalWantsItSo) {
  const std::vector<Action> opens{{ActionType::GoTo, {"fridge_1"}}, {ActionType::Open, {"fridge_1"}}};
  const auto plan = opens + fetch("mug_1") + put_on("sidetable_1");
  EXPECT_THAT(of(kMugOnTable, plan), ElementsAre(Pair(CarelessKind::LeftOpenOrOn, ElementsAre("fridge_1"))));
  EXPECT_THAT(of(kMugOnTable, opens + std::vector<Action>{{ActionType::Close, {"fridge_1"}}} + fetch("mug_1") +
                                  put_on("sidetable_1")),
              IsEmpty());
  EXPECT_THAT(of("(exists (?f - Fridge) (at-end (open ?f)))", opens), IsEmpty());
}

TEST_F(Careful, WhatIsLeftOnIsFoundUnlessTheGoalWantsItSo) {
  const std::vector<Action> on{{ActionType::GoTo, {"television_1"}}, {ActionType::TurnOn, {"television_1"}}};
  EXPECT_THAT(of(kMugOnTable, on + fetch("mug_1") + put_on("sidetable_1")),
              ElementsAre(Pair(CarelessKind::LeftOpenOrOn, ElementsAre("television_1"))));
  EXPECT_THAT(of("(exists (?t - Television) (at-end (power_on ?t)))", on), IsEmpty());
}

TEST_F(Careful, ADeviceOfAnotherRoomIsFoundIfANearerOneWouldDo) {
  add(start, knowledge, "microwave_2", "Microwave", 5.8, 3.65, 0.902);
  start = at_rest(start);
  const auto heat = [](const char* id) {
    return std::vector<Action>{{ActionType::GoTo, {id}}, {ActionType::HeatWith, {id}}};
  };
  EXPECT_THAT(of(kHot, fetch("potato_1") + heat("microwave_2")),
              ElementsAre(Pair(CarelessKind::FarAway, ElementsAre("microwave_2"))));
  EXPECT_THAT(of(kHot, fetch("potato_1") + heat("microwave_1")), IsEmpty());
}

}  // namespace
}  // namespace unietp::testing
