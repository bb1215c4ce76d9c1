// Plans are compared by what they take, and the cheapest is shown.
#include "expert/plan_cost.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "expert/execution.h"
#include "expert/parking.h"
#include "tests/expert/house.h"

namespace unietp::testing {
namespace {

struct Plans : ::testing::Test {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  Scene start = at_rest(house());
  Formula wanted;

  ExecutionTree executions(const std::string& text) {
    wanted = goal(text);
    return *ExecutionTree::of(wanted, start, knowledge, profile);
  }
};

using PlanCosts = Plans;
using Parking = Plans;

constexpr const char* kMugOnTable = "(exists (?x - Mug) (exists (?y - SideTable) (at-end (on ?x ?y))))";
const std::vector<Action> kToTheTable{
    {ActionType::GoTo, {"sidetable_1"}}, {ActionType::PlaceOn, {"sidetable_1"}}, {ActionType::Stop, {}}};

std::vector<Action> operator+(std::vector<Action> first, const std::vector<Action>& then) {
  first.insert(first.end(), then.begin(), then.end());
  return first;
}
std::vector<Action> fetch(const char* id) { return {{ActionType::GoTo, {id}}, {ActionType::PickUp, {id}}}; }

TEST_F(PlanCosts, AreStepsThenTheWayThenWhatIsDisturbed) {
  EXPECT_LT((PlanCost{5, 9, 9}), (PlanCost{6, 0, 0}));
  EXPECT_LT((PlanCost{5, 3, 9}), (PlanCost{5, 4, 0}));
  EXPECT_LT((PlanCost{5, 3, 0}), (PlanCost{5, 3, 1}));
}

TEST_F(PlanCosts, CountTheWayAndTheStepsThatCloseWhatIsOpened) {
  auto tree = executions(kMugOnTable);
  const auto plan = fetch("mug_1") + kToTheTable;
  const PlanCost cost = cost_of(tree, plan);
  EXPECT_EQ(cost.steps, 5);
  EXPECT_GE(cost.meters, 6) << "from the kitchen to the living room";
  EXPECT_LE(cost.meters, 12);
  EXPECT_EQ(cost.disturbed, 0);

  const std::vector<Action> opens{{ActionType::GoTo, {"fridge_1"}}, {ActionType::Open, {"fridge_1"}}};
  const PlanCost with_fridge = cost_of(tree, opens + plan);
  EXPECT_EQ(with_fridge.steps, 8) << "it is closed again";
  EXPECT_EQ(with_fridge.disturbed, 1);
  EXPECT_GT(with_fridge.meters, cost.meters);
  const PlanCost closed = cost_of(tree, opens + std::vector<Action>{{ActionType::Close, {"fridge_1"}}} + plan);
  EXPECT_EQ(closed.steps, 8);
  EXPECT_EQ(closed.disturbed, 0);
}

TEST_F(PlanCosts, CountWhatIsMovedThoughTheGoalDoesNotSpeakOfIt) {
  auto tree = executions(kMugOnTable);
  const std::vector<Action> onto_counter{{ActionType::GoTo, {"countertop_1"}}, {ActionType::PlaceOn, {"countertop_1"}}};
  EXPECT_EQ(cost_of(tree, fetch("apple_1") + onto_counter + fetch("mug_1") + kToTheTable).disturbed, 1);
  EXPECT_EQ(cost_of(tree, fetch("mug_2") + onto_counter + fetch("mug_1") + kToTheTable).disturbed, 0);
}

/// Those that the goal needs, of goals and homes of which the first plan that works is not always the best.
TEST_F(Plans, ThatAreShownCostNoMoreThanTheFirstThatWorks) {
  int cheaper = 0;
  for (const char* text : {"(exists (?b - SideTable) (at-end (and (count >= 2 (?a - Mug) (on ?a ?b)) (count >= 1 (?c - "
                           "Apple) (on ?c ?b)))))",
                           "(exists (?x - Mug) (exists (?y - Apple) (exists (?c - CounterTop) (exists (?d - Fridge) "
                           "(at-end (and (on ?x ?c)"
                           " (inside ?y ?d)))))))",
                           "(exists (?x - Potato) (exists (?p - Plate) (exists (?b - DiningTable) (at-end (and (on ?x "
                           "?p) (on ?p ?b))))))"}) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      start = strewn_house(Rng(seed));
      auto tree = executions(text);
      const auto first = find_plan(tree, {});
      const auto shown = demonstrate(tree, {});
      ASSERT_EQ(std::holds_alternative<Rejection>(first), std::holds_alternative<Rejection>(shown));
      if (std::holds_alternative<Rejection>(first)) continue;
      const PlanCost of_first = cost_of(tree, std::get<std::vector<Action>>(first));
      const PlanCost of_shown = cost_of(tree, actions_for_the_goal(std::get<Demonstration>(shown)));
      EXPECT_LE(of_shown, of_first) << text << " " << seed;
      cheaper += of_shown < of_first ? 1 : 0;
    }
  }
  EXPECT_GT(cheaper, 0) << "nothing is compared";
}

TEST_F(Parking, IsLeftOutWhereTheOtherCanComeFirst) {
  const std::string both =
      "(exists (?a - Apple) (exists (?f - Fridge) (exists (?m - Mug) (exists (?t - SideTable)"
      " (at-end (and (inside ?a ?f) (on ?m ?t)))))))";
  auto tree = executions(both);
  const std::vector<Action> aside{{ActionType::PlaceOn, {"diningtable_1"}}};
  const std::vector<Action> into_fridge{
      {ActionType::GoTo, {"fridge_1"}}, {ActionType::Open, {"fridge_1"}}, {ActionType::PlaceIn, {"fridge_1"}}};
  const auto parks = fetch("mug_1") + aside + fetch("apple_1") + into_fridge + fetch("mug_1") + kToTheTable;
  const auto better = without_parking(tree, parks, 0);
  EXPECT_EQ(better, fetch("apple_1") + into_fridge + fetch("mug_1") + kToTheTable);
  EXPECT_LT(cost_of(tree, better), cost_of(tree, parks));
  EXPECT_EQ(without_parking(tree, better, 0), better) << "nothing is parked";
  EXPECT_EQ(without_parking(tree, parks, 3), parks) << "what is done is done";
}

TEST_F(Parking, IsLeftOutWhereTheOtherIsInWhatIsOpenedFirst) {
  move_to(start, "apple_1", 4.4, 3.55, 0.9);  // in the fridge
  erase_if(start.nodes, [](const Node& node) { return node.id == "apple_2"; });
  start = at_rest(start);
  auto tree = executions(
      "(exists (?a - Apple) (exists (?f - Fridge) (exists (?m - Mug) (exists (?t - CounterTop)"
      " (at-end (and (on ?a ?t) (inside ?m ?f)))))))");
  const std::vector<Action> opens{{ActionType::GoTo, {"fridge_1"}}, {ActionType::Open, {"fridge_1"}}};
  const std::vector<Action> aside{{ActionType::GoTo, {"diningtable_1"}}, {ActionType::PlaceOn, {"diningtable_1"}}};
  const std::vector<Action> to_counter{{ActionType::GoTo, {"countertop_1"}}, {ActionType::PlaceOn, {"countertop_1"}}};
  const std::vector<Action> into_fridge{
      {ActionType::GoTo, {"fridge_1"}}, {ActionType::PlaceIn, {"fridge_1"}}, {ActionType::Stop, {}}};
  const auto parks = fetch("mug_1") + opens + aside + fetch("apple_1") + to_counter + fetch("mug_1") + into_fridge;
  const std::vector<Action> takes_out{{ActionType::PickUp, {"apple_1"}}};
  EXPECT_EQ(without_parking(tree, parks, 0), opens + takes_out + to_counter + fetch("mug_1") + into_fridge);
}

TEST_F(Parking, StaysWhereTheThingIsToBePutDown) {
  auto tree = executions(
      "(exists (?a - Apple) (exists (?m - Mug) (exists (?t - SideTable) (exists (?d - Dresser)"
      " (and (before (on ?m ?d) (on ?a ?t)) (at-end (on ?m ?t)))))))");
  const std::vector<Action> to_dresser{{ActionType::GoTo, {"dresser_1"}}, {ActionType::PlaceOn, {"dresser_1"}}};
  const std::vector<Action> to_table{{ActionType::GoTo, {"sidetable_1"}}, {ActionType::PlaceOn, {"sidetable_1"}}};
  const auto in_order = fetch("mug_1") + to_dresser + fetch("apple_1") + to_table + fetch("mug_1") + kToTheTable;
  EXPECT_EQ(without_parking(tree, in_order, 0), in_order);
}

}  // namespace
}  // namespace unietp::testing
