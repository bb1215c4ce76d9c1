#include "grounding/check_goal.h"

#include <gtest/gtest.h>

#include "homes.h"
#include "scene/trace.h"
#include "simulation/relations.h"

// The geometric gates: for each a start that it refuses, and one that differs in what decides and passes.
namespace unietp {
namespace {

class CheckGoal : public ::testing::Test {
 protected:
  void SetUp() override {
    style_ = style_of(Simulator::Ai2thor);
    ASSERT_TRUE(style_);
    scene_.id = "flat";
    scene_.simulator = Simulator::Ai2thor;
    scene_.wall_height = 2.5;
    scene_.rooms = {{"kitchen_1", "kitchen", {{0, 0}, {4, 0}, {4, 4}, {0, 4}}},
                    {"bathroom_1", "bathroom", {{4, 0}, {7, 0}, {7, 4}, {4, 4}}}};
    scene_.openings = {{"door_1", "kitchen_1", "bathroom_1", {4, 1.5}, {4, 2.5}, 2.0}};
    scene_.agent.position = {1, 1};
    add("counter_top_1", "CounterTop", Archetype::Block, {1.4, 0.6, 0.9}, {2, 3.7, 0.45});
    add("mug_1", "Mug", Archetype::Vessel, {0.1, 0.1, 0.12}, {1.5, 3.6, 0.961});
  }

  Node& add(const std::string& id, const std::string& category, Archetype archetype, const Vec3& size,
            const Vec3& middle) {
    Node node;
    node.id = id;
    node.category = category;
    node.archetype = archetype;
    node.size = size;
    node.mass = 1;
    node.pose.position = middle;
    node.movable = style_->knowledge.find(category)->movable;
    node.openable = style_->knowledge.has(category, "openable");
    if (node.openable) node.states.set({Predicate::Closed, ""});
    return scene_.nodes.emplace_back(std::move(node));
  }

  /// "" when the goal passes, else what is missing.
  std::string refused(const std::string& goal) {
    Specification specification;
    auto formula = parse_formula("test", goal, FormulaUse::Goal);
    EXPECT_TRUE(formula) << format(formula.error());
    specification.goal = *formula;
    const Home home = prepare_home(scene_, style_->profile);
    const GrownScene grown = read_grown(home, home.scene);
    Reach reach(home, home.scene, grown, style_->profile);
    const auto problem = check_goal(specification, home.scene, home.places, to_logic(home.scene, {}, true),
                                    style_->knowledge, style_->profile, reach, pictured_);
    if (problem) {
      EXPECT_EQ(problem->reason, pictured_ ? RejectionReason::NotSeen : reason_);
    }
    return problem ? problem->detail : "";
  }

  std::optional<Surroundings> style_;
  Scene scene_;
  bool pictured_ = false;
  RejectionReason reason_ = RejectionReason::NoSpot;
};

const std::string kMugOnCounter = "(exists (?a - Mug) (exists (?b - CounterTop) (at-end (on ?a ?b))))";

TEST_F(CheckGoal, ASurfaceRightBelowSomethingFixedTakesNothing) {
  scene_.nodes.edit(1).pose.position = Vec3(2, 1, 0.061);  // the mug stands on the floor
  EXPECT_EQ(refused(kMugOnCounter), "");
  add("shelf_1", "Shelf", Archetype::Block, {1.5, 0.7, 0.1}, {2, 3.7, 1.0});
  EXPECT_NE(refused(kMugOnCounter).find("on of mug_1 and counter_top_1"), std::string::npos);
}

TEST_F(CheckGoal, WhatCanBeCarriedAwayTakesNoRoom) {
  scene_.nodes.edit(1).pose.position = Vec3(2, 1, 0.061);
  for (int i = 0; i < 6; ++i)
    add("box_" + std::to_string(i + 1), "Box", Archetype::Lidded, {0.22, 0.55, 0.3}, {1.42 + 0.23 * i, 3.7, 1.051});
  EXPECT_EQ(refused(kMugOnCounter), "");
}

TEST_F(CheckGoal, ASurfaceThatNoArmGetsToTakesNothing) {
  scene_.nodes.edit(1).pose.position = Vec3(2, 1, 0.061);
  scene_.nodes.edit(0).pose.position.z() = 1.8;
  EXPECT_EQ(refused(kMugOnCounter), "");
  scene_.nodes.edit(0).pose.position.z() = 3.4;
  EXPECT_NE(refused(kMugOnCounter), "");
}

TEST_F(CheckGoal, ANumberAsksForAsManyAsItSays) {
  const auto inside = [](const std::string& number) {
    return "(exists (?b - Microwave) (at-end (count " + number + " (?a - Mug) (inside ?a ?b))))";
  };
  add("microwave_1", "Microwave", Archetype::Cabinet, {0.5, 0.36, 0.3}, {2.3, 3.65, 1.052});
  EXPECT_EQ(refused(inside("= 1")), "");
  EXPECT_EQ(refused(inside("> 0")), "");
  scene_.nodes.edit(1).size = {0.45, 0.45, 0.45};
  EXPECT_NE(refused(inside("= 1")), "");
  EXPECT_NE(refused(inside(">= 1")), "");
  EXPECT_NE(refused(inside("> 0")), "");
  EXPECT_EQ(refused(inside("= 0")), "") << "nothing has to go in";
  EXPECT_EQ(refused(inside("<= 1")), "");
}

TEST_F(CheckGoal, AThingHasToFitIntoWhatItGoesInto) {
  const std::string goal = "(exists (?a - Mug) (exists (?b - Microwave) (at-end (inside ?a ?b))))";
  add("microwave_1", "Microwave", Archetype::Cabinet, {0.5, 0.36, 0.3}, {2.3, 3.65, 1.052});
  EXPECT_EQ(refused(goal), "");
  scene_.nodes.edit(1).size = {0.45, 0.45, 0.45};
  EXPECT_NE(refused(goal).find("inside of mug_1 and microwave_1"), std::string::npos);
}

TEST_F(CheckGoal, ADoorMustNotMeetWhatIsFixedOnItsWay) {
  const std::string goal = "(exists (?a - Fridge) (at-end (open ?a)))";
  add("fridge_1", "Fridge", Archetype::Cabinet, {0.7, 0.65, 1.7}, {0.6, 3.6, 0.85});
  EXPECT_EQ(refused(goal), "");
  Node& before = add("box_1", "Box", Archetype::Lidded, {0.5, 0.3, 0.3}, {0.6, 3.05, 0.151});
  EXPECT_EQ(refused(goal), "") << "a box can be carried away";
  before.category = "SideTable";
  before.movable = false;
  EXPECT_NE(refused(goal).find("open of fridge_1"), std::string::npos);
  EXPECT_NE(refused("(exists (?a - Mug) (exists (?b - Fridge) (at-end (inside ?a ?b))))"), "")
      << "nothing gets in behind such a door";
}

TEST_F(CheckGoal, AnApplianceThatTakesTheThingHasToBeThere) {
  const std::string goal = "(exists (?a - Mug) (at-end (filled ?a coffee)))";
  add("coffee_machine_1", "CoffeeMachine", Archetype::Block, {0.25, 0.35, 0.3}, {2.3, 3.7, 1.052});
  EXPECT_EQ(refused(goal), "");
  add("shelf_1", "Shelf", Archetype::Block, {1.5, 0.7, 0.1}, {2, 3.7, 1.27});
  EXPECT_NE(refused(goal).find("filled of mug_1"), std::string::npos);
}

TEST_F(CheckGoal, WhereNothingCanBeDroppedARoomNeedsFurniture) {
  const std::string goal = "(exists (?a - Mug) (exists (?r - bathroom) (at-end (in_room ?a ?r))))";
  EXPECT_EQ(refused(goal), "") << "it is let fall";
  style_->profile.actions[static_cast<std::size_t>(ActionType::Drop)] = false;
  EXPECT_NE(refused(goal).find("in_room of mug_1"), std::string::npos);
  add("side_table_1", "SideTable", Archetype::Table, {0.5, 0.5, 0.6}, {6, 3, 0.3});
  EXPECT_EQ(refused(goal), "");
}

TEST_F(CheckGoal, OneOfSeveralIsEnoughWhereOneIsAskedForAndNotWhereAllAre) {
  scene_.nodes.edit(1).pose.position = Vec3(2, 1, 0.061);
  add("shelf_1", "Shelf", Archetype::Block, {1.5, 0.7, 0.1}, {2, 3.7, 1.0});
  add("counter_top_2", "CounterTop", Archetype::Block, {0.6, 1.4, 0.9}, {0.3, 2, 0.45});
  EXPECT_EQ(refused(kMugOnCounter), "");
  EXPECT_NE(refused("(exists (?a - Mug) (forall (?b - CounterTop) (sometime (on ?a ?b))))"), "");
  EXPECT_EQ(refused("(at-end (forall (?a - Mug) (not (exists (?b - CounterTop) (on ?a ?b)))))"), "");
  EXPECT_EQ(refused("(at-end (count = 1 (?b - CounterTop) (exists (?a - Mug) (on ?a ?b))))"), "");
  EXPECT_NE(refused("(at-end (count >= 2 (?b - CounterTop) (exists (?a - Mug) (on ?a ?b))))"), "");
}

TEST_F(CheckGoal, WhatSharesAPlaceHasToFindRoomThereTogether) {
  reason_ = RejectionReason::NotTogether;
  scene_.nodes.edit(1).pose.position = Vec3(1, 2.5, 0.061);
  scene_.nodes.edit(1).size = {0.3, 0.3, 0.12};
  add("mug_2", "Mug", Archetype::Vessel, {0.3, 0.3, 0.12}, {1, 2, 0.061});
  add("plate_1", "Plate", Archetype::Plate, {0.3, 0.3, 0.02}, {1.5, 2.5, 0.011});
  Node& table = add("side_table_1", "SideTable", Archetype::Table, {0.4, 0.4, 0.6}, {2.5, 1, 0.3});
  const std::string one = "(exists (?a - Mug) (exists (?t - SideTable) (at-end (on ?a ?t))))";
  const std::string both =
      "(exists (?t - SideTable) (exists (?a - Mug) (exists (?b - Plate) (at-end (and (on ?a ?t) (on ?b ?t))))))";
  const std::string in_turn =
      "(exists (?t - SideTable) (exists (?a - Mug) (exists (?b - Plate) (before (on ?a ?t) (on ?b ?t)))))";
  const std::string all = "(exists (?t - SideTable) (at-end (forall (?a - Mug) (on ?a ?t))))";
  EXPECT_EQ(refused(one), "");
  EXPECT_EQ(refused(both), "side_table_1 has no room for 2 things such as mug_1 at once");
  EXPECT_NE(refused(all), "");
  EXPECT_EQ(refused(in_turn), "") << "the first may be gone when the second comes";
  table.size = {0.8, 0.4, 0.6};
  EXPECT_EQ(refused(both), "");
  EXPECT_EQ(refused(all), "");
}

TEST_F(CheckGoal, WhatIsToBePointedAtInAPictureMustNotBeASpeck) {
  EXPECT_EQ(refused("(exists (?a - Mug) (at-end (held ?a)))"), "");
  pictured_ = true;
  EXPECT_EQ(refused("(exists (?a - Mug) (at-end (held ?a)))"), "");
  scene_.nodes.edit(1).size = {0.003, 0.003, 0.003};
  scene_.nodes.edit(1).pose.position.z() = 0.902;
  EXPECT_EQ(refused("(exists (?a - Mug) (at-end (held ?a)))"), "mug_1 shows clearly from nowhere");
  pictured_ = false;
  EXPECT_EQ(refused("(exists (?a - Mug) (at-end (held ?a)))"), "") << "who names it by its id needs no picture";
}

TEST_F(CheckGoal, WhatIsToBeCutNeedsSomethingToCutItWith) {
  add("bread_1", "Bread", Archetype::Box, {0.2, 0.1, 0.1}, {1.6, 3.7, 0.951});
  for (const std::string goal :
       {"(exists (?s - Bread/slice) (at-end (held ?s)))", "(exists (?a - Bread) (at-end (sliced ?a)))"}) {
    SCOPED_TRACE(goal);
    EXPECT_EQ(refused(goal), "there is nothing that cuts Bread");
  }
  Node& knife = add("knife_1", "Knife", Archetype::Box, {0.25, 0.03, 0.02}, {2.3, 3.7, 0.911});
  for (const std::string goal :
       {"(exists (?s - Bread/slice) (at-end (held ?s)))", "(exists (?a - Bread) (at-end (sliced ?a)))"}) {
    SCOPED_TRACE(goal);
    pictured_ = false;
    knife.size = {0.25, 0.03, 0.02};
    EXPECT_EQ(refused(goal), "");
    pictured_ = true;
    EXPECT_EQ(refused(goal), "");
    knife.size = {0.003, 0.003, 0.003};
    EXPECT_EQ(refused(goal), "knife_1 shows clearly from nowhere");
  }
}

}  // namespace
}  // namespace unietp
