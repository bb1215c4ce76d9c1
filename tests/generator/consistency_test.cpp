#include "generator/consistency.h"

#include <gtest/gtest.h>

#include "generator/goal_parts.h"
#include "small_home.h"

namespace unietp {
namespace {

Formula goal(const std::string& text) {
  auto parsed = parse_formula("test", text, FormulaUse::Goal);
  EXPECT_TRUE(parsed) << format(parsed.error());
  return *parsed;
}

Specification with(const std::string& goal_text, const std::vector<std::string>& init = {}) {
  Specification made;
  made.goal = goal(goal_text);
  for (const auto& text : init) made.init.push_back(*parse_formula("test", text, FormulaUse::State));
  return made;
}

std::string why_not(const std::string& goal_text, const std::vector<std::string>& init = {}) {
  return contradiction(with(goal_text, init), small_home(Simulator::Ai2thor)).value_or(GateRefusal{}).reason;
}

TEST(Contradiction, OneObjectInTwoExclusiveStates) {
  EXPECT_NE(why_not("(exists (?a - Mug) (at-end (and (hot ?a) (cool ?a))))").find("exclusive"), std::string::npos);
  EXPECT_NE(why_not("(exists (?a - Mug) (and (at-end (clean ?a)) (at-end (dirty ?a))))"), "");
  EXPECT_NE(why_not("(exists (?a - Mug) (at-end (and (clean ?a) (not (clean ?a)))))").find("opposite"),
            std::string::npos);
}

TEST(Contradiction, StatesAtDifferentTimesOrOfDifferentObjectsAreFine) {
  EXPECT_EQ(why_not("(exists (?a - Fridge) (and (sometime (open ?a)) (at-end (closed ?a))))"), "");
  EXPECT_EQ(why_not("(exists (?a - Mug) (exists (?b - Mug) (at-end (and (hot ?a) (cool ?b)))))"), "");
}

TEST(Contradiction, AStateThatItsKindOfThingNeverHas) {
  EXPECT_NE(why_not("(exists (?a - Mug) (at-end (closed ?a)))").find("is not openable"), std::string::npos);
  EXPECT_NE(why_not("(exists (?k - kitchen) (at-end (closed ?k)))").find("kitchen is not openable"), std::string::npos);
  EXPECT_EQ(why_not("(exists (?a - Fridge) (at-end (closed ?a)))"), "");
}

TEST(Contradiction, OneObjectInTwoPlaces) {
  EXPECT_NE(
      why_not("(exists (?a - Mug) (exists (?b - Table) (exists (?c - Shelf) (at-end (and (on ?a ?b) (on ?a ?c))))))")
          .find("two places"),
      std::string::npos);
  EXPECT_NE(why_not("(exists (?a - Mug) (exists (?b - Table) (exists (?c - Fridge) (at-end (and (on ?a ?b) (inside ?a "
                    "?c))))))"),
            "");
}

TEST(Contradiction, DifferentObjectsMayBeInDifferentPlacesAndStates) {
  EXPECT_EQ(why_not("(and (forall (?a - (Bread :where (cooked ?a))) (at-end (exists (?b - Table) (on ?a ?b)))) "
                    "(forall (?a - (Bread :where (raw ?a))) (at-end (exists (?c - Shelf) (on ?a ?c)))))"),
            "");
  EXPECT_EQ(why_not("(and (exists (?a - Mug) (at-end (hot ?a))) (exists (?a - Mug) (at-end (cool ?a))))"), "");
}

TEST(Contradiction, AllObjectsInTwoPlacesOrStates) {
  EXPECT_NE(why_not("(and (forall (?a - Mug) (at-end (exists (?b - Table) (on ?a ?b)))) "
                    "(forall (?x - Mug) (at-end (exists (?c - Shelf) (on ?x ?c)))))")
                .find("two places: (on ?a ?b) and (on ?a ?c)"),
            std::string::npos);
  EXPECT_NE(why_not("(and (forall (?a - Mug) (at-end (hot ?a))) (forall (?b - Mug) (at-end (cool ?b))))"), "");
}

TEST(Contradiction, MoreObjectsThanFit) {
  const std::string in = "(at-end (count >= ";
  EXPECT_EQ(why_not("(exists (?c - Fridge) " + in + "4 (?a - Mug) (inside ?a ?c))))"), "");
  EXPECT_NE(why_not("(exists (?c - Fridge) " + in + "5 (?a - Mug) (inside ?a ?c))))").find("at most 4 fit"),
            std::string::npos);
  const std::string all = "(exists (?c - Microwave) (forall (?a - Mug) (at-end (inside ?a ?c))))";
  EXPECT_EQ(why_not(all, {"(exists (?a - Mug) (and))"}), "");
  EXPECT_NE(why_not(all, {"(count >= 2 (?a - Mug) (and))"}), "");
}

TEST(Contradiction, APlaceOrStateThatTheKnowledgeBaseDoesNotAllow) {
  EXPECT_NE(why_not("(exists (?a - Mug) (exists (?b - Lamp) (at-end (on ?a ?b))))").find("does not allow"),
            std::string::npos);
  EXPECT_NE(why_not("(exists (?a - Table) (at-end (open ?a)))").find("not openable"), std::string::npos);
}

TEST(Contradiction, CountsThatExcludeEachOther) {
  EXPECT_NE(
      why_not("(exists (?c - Table) (at-end (and (count >= 3 (?a - Mug) (on ?a ?c)) (count <= 2 (?b - Mug) (on ?b "
              "?c)))))")
          .find("two different numbers"),
      std::string::npos);
}

TEST(BadStart, FindsAGoalThatTheStartMayAlreadyMeet) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  const std::string open = "(exists (?a - Fridge) (at-end (open ?a)))";
  EXPECT_TRUE(bad_start(with(open), knowledge, 20));
  EXPECT_TRUE(bad_start(with(open, {"(exists (?a - Fridge) (closed ?a))"}), knowledge, 40));
  EXPECT_FALSE(bad_start(with(open, {"(forall (?a - Fridge) (closed ?a))"}), knowledge, 40));
}

TEST(BadStart, LooksAtEachPartAndNotOnlyAtTheWhole) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  const std::string both = "(exists (?a - Mug) (exists (?b - Table) (at-end (and (clean ?a) (on ?a ?b)))))";
  EXPECT_TRUE(bad_start(with(both, {"(forall (?a - Mug) (dirty ?a))"}), knowledge, 40));
}

TEST(BadStart, SaysSoWhenNoStartExists) {
  const auto spec = with("(exists (?a - Mug) (at-end (held ?a)))",
                         {"(forall (?a - Mug) (dirty ?a))", "(exists (?a - Mug) (clean ?a))"});
  const auto refusal = bad_start(spec, small_home(Simulator::Ai2thor), 1);
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->gate, Gate::Start);
}

TEST(GoalParts, AreTheConjunctsWithTheirQuantifiers) {
  const auto parts = goal_parts(goal("(exists (?a - A) (exists (?b - B) (at-end (and (clean ?a) (on ?a ?b)))))"));
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(to_text(parts[0]), "(exists (?a - A) (at-end (clean ?a)))");
  EXPECT_EQ(to_text(parts[1]), "(exists (?a - A) (exists (?b - B) (at-end (on ?a ?b))))");
}

TEST(GoalParts, LeaveOutWhatIsOnlyKept) {
  EXPECT_EQ(
      goal_parts(goal("(and (forall (?c - C) (always (closed ?c))) (exists (?a - A) (at-end (held ?a))))")).size(), 1U);
  EXPECT_EQ(
      goal_parts(goal("(and (forall (?a - A) (at-end (open ?a))) (at-end (count = 0 (?o - A) (held ?o))))")).size(),
      1U);
}

TEST(GoalParts, KeepUndoingAndRestoringTogether) {
  const auto parts = goal_parts(goal("(exists (?a - A) (and (sometime (open ?a)) (at-end (closed ?a))))"));
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(to_text(parts[0]), "(exists (?a - A) (and (sometime (open ?a)) (at-end (closed ?a))))");
}

}  // namespace
}  // namespace unietp
