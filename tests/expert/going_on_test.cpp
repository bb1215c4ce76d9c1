#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "expert/execution.h"
#include "expert/exploration.h"
#include "logic/evaluate.h"
#include "tests/expert/house.h"

// What the expert does when a plan did not go as planned: it goes on from where it stands, with what it has learnt.
namespace unietp::testing {
namespace {

using ::testing::Contains;
using ::testing::Not;

struct GoingOn : ::testing::Test {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();

  std::vector<Action> plan(const std::string& text, const Scene& start, const ExecutedPrefix& beginning) const {
    const Formula formula = goal(text);
    auto executions = ExecutionTree::of(formula, start, knowledge, profile);
    EXPECT_TRUE(executions);
    auto result = find_plan_from(*executions, beginning, {});
    if (const auto* rejection = std::get_if<Rejection>(&result)) {
      ADD_FAILURE() << name_of(rejection->reason) << ": " << rejection->detail;
      return {};
    }
    auto actions = beginning.done;
    const auto& others = std::get<std::vector<Action>>(result);
    actions.insert(actions.end(), others.begin(), others.end());
    World world = *World::create(start, knowledge, profile);
    std::vector<Delta> changes;
    for (const Action& action : actions) {
      EXPECT_TRUE(world.step(action).success) << to_text(action);
      changes.push_back(world.changes());
    }
    EXPECT_TRUE(holds(formula, to_logic(start, changes)));
    return others;
  }
};

const char* const kMugOnSideTable = "(exists (?x - Mug) (exists (?y - SideTable) (at-end (on ?x ?y))))";

TEST_F(GoingOn, DoesOnlyWhatIsStillToDo) {
  const Scene start = at_rest(house());
  auto first = plan(kMugOnSideTable, start, {});
  const auto picked =
      std::find_if(first.begin(), first.end(), [](const auto& a) { return a.type == ActionType::PickUp; });
  ASSERT_NE(picked, first.end());
  const std::vector<Action> done(first.begin(), picked + 1), rest(picked + 1, first.end());
  EXPECT_EQ(plan(kMugOnSideTable, start, {done, {}}), rest);
}

TEST_F(GoingOn, DoesAgainWhatWasUndone) {
  const Scene start = at_rest(house());
  auto done = plan(kMugOnSideTable, start, {});
  const auto picked =
      std::find_if(done.begin(), done.end(), [](const auto& a) { return a.type == ActionType::PickUp; });
  ASSERT_NE(picked, done.end());
  done.back() = *picked;  // instead of stopping
  const auto rest = plan(kMugOnSideTable, start, {done, {}});
  ASSERT_EQ(rest.size(), 2u);
  EXPECT_EQ(rest.front().type, ActionType::PlaceOn);
}

TEST_F(GoingOn, TakesAnotherThingForOneThatWasNotComeTo) {
  const Scene start = at_rest(house());
  const auto first = plan(kMugOnSideTable, start, {});
  const auto picked =
      std::find_if(first.begin(), first.end(), [](const auto& a) { return a.type == ActionType::PickUp; });
  ASSERT_NE(picked, first.end());
  EXPECT_THAT(plan(kMugOnSideTable, start, {{}, {picked->args.front()}}), Not(Contains(*picked)));
}

TEST_F(GoingOn, TakesAnotherToolForOneThatWasNotComeTo) {
  Scene scene = house();
  Node other = *find_node(scene, "knife_1");
  other.id = "knife_2";
  other.pose.position.x() -= 0.3;
  scene.nodes.push_back(other);
  const Scene start = at_rest(std::move(scene));
  const std::string sliced = "(exists (?x - Apple) (at-end (sliced ?x)))";
  const auto taken = [&](const ExecutedPrefix& beginning) {
    std::string knife;
    for (const Action& action : plan(sliced, start, beginning)) {
      if (action.type == ActionType::PickUp && action.args.front().starts_with("knife")) knife = action.args.front();
    }
    return knife;
  };
  const std::string first = taken({}), second = first == "knife_1" ? "knife_2" : "knife_1";
  EXPECT_EQ(taken({{}, {first}}), second);
  EXPECT_EQ(taken({{}, {second}}), first);
  EXPECT_NE(taken({{}, {first, second}}), "") << "one that is avoided is better than none";
}

TEST_F(GoingOn, CutsInTheOpenWhereItIsAskedToClear) {
  Scene scene = house();
  erase_if(scene.nodes, [](const Node& node) { return node.id == "apple_2"; });
  move_to(scene, "apple_1", 4.4, 3.55, 0.9);
  const Scene start = at_rest(std::move(scene));
  const char* const slice = "(exists (?s - Apple/slice) (exists (?b - SideTable) (at-end (on ?s ?b))))";
  const Action out{ActionType::PickUp, {"apple_1"}};
  EXPECT_THAT(plan(slice, start, {}), Not(Contains(out)));
  EXPECT_THAT(plan(slice, start, {{}, {}, true}), Contains(out));
}

TEST_F(GoingOn, LooksAroundFromWhereItStands) {
  Scene scene = house();
  scene.agent.yaw = 0;
  const World world = *World::create(at_rest(std::move(scene)), knowledge, profile);
  const ModeEpisode episode(world, Mode::M3);
  const auto way = way_to_see(episode, "dresser_1", Viewpoint::Here);  // behind its back
  ASSERT_TRUE(way);
  EXPECT_FALSE(way->empty());
  for (const Action& step : *way) {
    EXPECT_THAT((std::vector{ActionType::TurnLeft, ActionType::TurnRight, ActionType::LookDown, ActionType::LookUp}),
                Contains(step.type));
  }
  EXPECT_FALSE(way_to_see(episode, "laptop_1", Viewpoint::Here)) << "in the other room";
  EXPECT_TRUE(way_to_see(episode, "laptop_1"));
  std::size_t one = 1, many = 10'000;
  EXPECT_FALSE(way_to_see(episode, "laptop_1", Viewpoint::Anywhere, &one)) << "looked from one pose only";
  EXPECT_EQ(one, 0u);
  EXPECT_TRUE(way_to_see(episode, "laptop_1", Viewpoint::Anywhere, &many));
  EXPECT_LT(many, 10'000u);
}

/// The house with vessels of which the sink fills one kind only.
Knowledge with_vessels() {
  const Knowledge plain = house_knowledge();
  const Source curated{"curated", 1};
  auto affordances = plain.affordances();
  for (const char* vessel : {"Mug", "Television"}) affordances.push_back({vessel, "fillable", curated});
  affordances.push_back({"Sink", "switchable", curated});
  auto effects = plain.effects();
  effects.push_back({"Sink", Treatment::Fills, "Mug", "water", 0, {EffectNeed::Inside, EffectNeed::UnderTap}, curated});
  return Knowledge(Simulator::Ai2thor, plain.categories(), affordances, plain.placements(), effects, plain.aliases());
}

/// A start in which all of them are empty.
Scene with_empty_vessels(const Knowledge& knowledge) {
  Scene start = house();
  for (std::size_t i = 0; i < start.nodes.size(); ++i) {
    Node& node = start.nodes.edit(i);
    if (knowledge.has(node.category, "fillable")) node.states.set({Predicate::Empty, ""});
    if (node.category == "Sink") node.states.set({Predicate::PowerOff, ""});
  }
  return at_rest(std::move(start));
}

TEST(FromVessel, WhatCannotBeCarriedToTheTapIsFilledFromSomethingThatCan) {
  const Knowledge knowledge = with_vessels();
  const Scene start = with_empty_vessels(knowledge);
  const Formula filled = goal("(exists (?x - Television) (at-end (filled ?x water)))");
  for (const bool composite : {true, false}) {
    Profile profile = house_profile();
    if (!composite) profile.actions.reset(static_cast<std::size_t>(ActionType::FillWith));
    const auto shown = demonstrate(filled, start, knowledge, profile, {});
    ASSERT_TRUE(std::holds_alternative<Demonstration>(shown)) << std::get<Rejection>(shown).detail;
    EXPECT_THAT(plan_of(std::get<Demonstration>(shown)), ::testing::HasSubstr("pour_to(television_1)"));
    EXPECT_EQ(replay(filled, start, std::get<Demonstration>(shown), knowledge, profile), "");
  }
}

/// Why that is no constraint (logic/constraints.h).
TEST(FromVessel, IsFilledFirstByWhoIsNotToldToDoSo) {
  const Knowledge knowledge = with_vessels();
  const Profile profile = house_profile();
  const Scene start = with_empty_vessels(knowledge);
  const std::string vessels = "(exists (?m - Mug) (exists (?x - Television) (and ";
  const Formula both = goal(vessels + "(sometime (filled ?m water)) (at-end (filled ?x water)))))");
  const Formula in_order = goal(vessels + "(before (filled ?m water) (filled ?x water)) (at-end (filled ?x water)))))");
  const auto shown = demonstrate(both, start, knowledge, profile, {});
  ASSERT_TRUE(std::holds_alternative<Demonstration>(shown)) << std::get<Rejection>(shown).detail;
  EXPECT_EQ(replay(in_order, start, std::get<Demonstration>(shown), knowledge, profile), "");
}

}  // namespace
}  // namespace unietp::testing
