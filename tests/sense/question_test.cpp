#include "sense/question.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/sense/committed_sense.h"
#include "tests/support/committed_knowledge.h"

namespace unietp {
namespace {

using ::testing::HasSubstr;

std::string goal_of(const std::string& question) {
  const auto goal = read_question(question, committed_knowledge(Simulator::Ai2thor));
  return goal ? to_text(*goal) : format(goal.error());
}

TEST(Question, IsReadAsAGoal) {
  EXPECT_EQ(goal_of("place Mug on CounterTop"), "(exists (?a - Mug) (exists (?b - CounterTop) (at-end (on ?a ?b))))");
  EXPECT_EQ(goal_of("put cell phone in drawer"),
            "(exists (?a - CellPhone) (exists (?b - Drawer) (at-end (inside ?a ?b))))");
  EXPECT_EQ(goal_of("switch off FloorLamp"), "(exists (?a - FloorLamp) (at-end (power_off ?a)))");
  EXPECT_EQ(goal_of("fill Mug with coffee"), "(exists (?a - Mug) (at-end (filled ?a coffee)))");
  EXPECT_EQ(goal_of("dust Desk"), "(exists (?a - Desk) (at-end (not (covered ?a dust))))");
  EXPECT_EQ(goal_of("throw away Newspaper"),
            "(exists (?a - Newspaper) (exists (?b - GarbageCan) (at-end (inside ?a ?b))))");
  EXPECT_EQ(goal_of("heat Potato in Microwave"),
            "(exists (?a - Potato) (exists (?b - Microwave) (and (at-end (inside ?a ?b)) (at-end (hot ?a)))))");
  EXPECT_EQ(goal_of("bring Pillow to bedroom"),
            "(exists (?a - Pillow) (exists (?b - bedroom) (at-end (in_room ?a ?b))))");
}

TEST(Question, ThenIsAboutOneThing) {
  EXPECT_EQ(goal_of("cook Potato then place Potato on Plate"),
            "(exists (?a - Potato) (and (at-end (cooked ?a)) (exists (?b - Plate) (at-end (on ?a ?b)))))");
}

TEST(Question, UnknownWordsGetTheNearest) {
  EXPECT_THAT(goal_of("place Mugg on CounterTop"), HasSubstr("did you mean \"Mug\""));
  EXPECT_THAT(goal_of("place Mgu on CounterTop"), HasSubstr("did you mean \"Mug\""));
  EXPECT_THAT(goal_of("place notebook on CounterTop"), HasSubstr("did you mean \"Book\""));
  EXPECT_THAT(goal_of("hoat Potato"), HasSubstr("did you mean \"heat\""));
  EXPECT_THAT(goal_of("place Mug CounterTop"), HasSubstr("expected one of"));
  EXPECT_THAT(goal_of("place Mug on couch"), HasSubstr("did you mean \"Sofa\""));  // people call it so
  EXPECT_THAT(goal_of("place Mug on table"), HasSubstr("\"DiningTable\""));        // a word of its name
}

std::string fault_in(const std::string& goal) {
  const auto parsed = parse_formula("goal", goal, FormulaUse::Goal);
  EXPECT_TRUE(parsed) << goal;
  const auto checked = check_names(*parsed, committed_knowledge(Simulator::Ai2thor), test::committed_words());
  return checked ? "" : checked.error().message;
}

TEST(Question, NamesOfAGoalAreChecked) {
  EXPECT_EQ(fault_in("(exists (?c - Cup) (at-end (filled ?c water)))"), "");
  EXPECT_EQ(fault_in("(exists (?t - DiningTable) (at-end (not (covered ?t dust))))"), "");
  EXPECT_EQ(fault_in("(exists (?t - DiningTable) (at-end (covered ?t pesticide)))"),
            "");  // of the words, not the facts
  EXPECT_EQ(fault_in("(exists (?a - Pillow) (exists (?r - bedroom) (at-end (in_room ?a ?r))))"), "");
  EXPECT_THAT(fault_in("(exists (?c - Cup) (at-end (filled ?c watr)))"), HasSubstr("did you mean \"water\""));
  EXPECT_THAT(fault_in("(exists (?c - Cup) (at-end (covered ?c blorp)))"), HasSubstr("unknown name \"blorp\""));
  EXPECT_THAT(fault_in("(exists (?c - Cupp) (at-end (clean ?c)))"), HasSubstr("did you mean \"Cup\""));
  EXPECT_THAT(fault_in("(exists (?a - (Book :where (exists (?b - Shelff) (on ?a ?b)))) (at-end (held ?a)))"),
              HasSubstr("did you mean \"Shelf\""));
}

}  // namespace
}  // namespace unietp
