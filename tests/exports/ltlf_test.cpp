// Goals as LTLf, read by an evaluator of the tests, against the program's own evaluator.
#include "exports/ltlf_formula.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "logic/evaluate.h"
#include "ltlf_reader.h"
#include "tests/logic/random_goals.h"

namespace unietp::testing {
namespace {

using ::testing::HasSubstr;

LtlfTrace named(const LtlfGoal& goal, const Trace& trace) {
  LtlfTrace states;
  for (const Facts& facts : trace.states) {
    states.emplace_back();
    for (const auto& proposition : goal.propositions) {
      if (proposition.holds_in(facts)) states.back().insert(proposition.name);
    }
  }
  return states;
}

TEST(Ltlf, RandomGoalsMeanTheSameOnRandomTraces) {
  int compared = 0, satisfied = 0;
  for (std::uint64_t seed = 0; seed < 6000; ++seed) {
    SCOPED_TRACE(seed);
    const Trace trace = random_trace(Rng(seed).fork("trace", 0)), start = prefix_of(trace, 1);
    if (trace.entities.size() != start.entities.size()) continue;  // something appears later
    const Formula goal = GoalWriter(Rng(seed).fork("goal", 0)).goal();
    const auto ltlf = ltlf_goal(goal, start);
    if (!ltlf) continue;
    const bool expected = holds(goal, trace);
    ASSERT_EQ(ltlf_holds(ltlf->formula, named(*ltlf, trace)), expected) << to_text(goal) << "\n" << ltlf->formula;
    ++compared;
    satisfied += expected ? 1 : 0;
  }
  EXPECT_GT(compared, 300);
  EXPECT_GT(satisfied, 50);
  EXPECT_LT(satisfied, compared - 50);
}

/// Whether something is gone that was there.
bool loses_something(const Trace& trace) {
  for (std::size_t i = 1; i < trace.states.size(); ++i) {
    for (std::size_t e = 0; e < trace.entities.size(); ++e) {
      if (trace.states[i - 1].exists(EntityIndex(e)) && !trace.states[i].exists(EntityIndex(e))) return true;
    }
  }
  return false;
}

TEST(Ltlf, GoalsAboutWhatComesLaterMeanTheSame) {
  int compared = 0, later = 0, satisfied = 0;
  for (std::uint64_t seed = 0; seed < 20000; ++seed) {
    SCOPED_TRACE(seed);
    const Trace trace = random_trace(Rng(seed).fork("trace", 0));
    if (loses_something(trace)) continue;
    const Formula goal = GoalWriter(Rng(seed).fork("goal", 0)).goal();
    const auto ltlf = ltlf_goal(goal, trace);
    if (!ltlf) continue;
    const bool expected = holds(goal, trace);
    ASSERT_EQ(ltlf_holds(ltlf->formula, named(*ltlf, trace)), expected) << to_text(goal) << "\n" << ltlf->formula;
    ++compared;
    later += ltlf->formula.find("exists_") != std::string::npos ? 1 : 0;
    satisfied += expected ? 1 : 0;
  }
  EXPECT_GT(compared, 300);
  EXPECT_GT(later, 30);
  EXPECT_GT(satisfied, 50);
}

Trace three_mugs() {
  using Kind = Entity::Kind;
  Trace trace;
  trace.entities = {{Kind::Agent, "agent", "agent", ""},
                    {Kind::Object, "mug_1", "Mug", ""},
                    {Kind::Object, "mug-1", "Mug", ""},
                    {Kind::Object, "Mug 1", "Mug", ""}};
  trace.states.resize(1);
  for (std::size_t i = 0; i < 4; ++i) trace.states[0].set_exists(EntityIndex(i));
  return trace;
}

TEST(Ltlf, NamesOfPropositionsAreDistinctAndLowerCase) {
  const auto ltlf = ltlf_goal(goal_of("(at-end (forall (?m - Mug) (dirty ?m)))"), three_mugs());
  ASSERT_TRUE(ltlf);
  std::map<std::string, std::vector<std::string>> arguments;
  for (const auto& one : ltlf->propositions) {
    EXPECT_EQ(one.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"), std::string::npos) << one.name;
    arguments[one.name] = one.arguments;
  }
  EXPECT_EQ(arguments.size(), 3U);
  EXPECT_EQ(arguments["dirty_mug_1"], std::vector<std::string>{"mug_1"});
  EXPECT_EQ(ltlf->formula, "G(F((dirty_mug_1) & (dirty_2_mug_1) & (dirty_3_mug_1)))");
}

TEST(Ltlf, RefusesWhatTheStartDoesNotHaveYetAndWhatGrowsTooLong) {
  const auto pieces = ltlf_goal(goal_of("(at-end (exists (?m - Mug/slice) (dirty ?m)))"), three_mugs());
  ASSERT_FALSE(pieces);
  EXPECT_THAT(pieces.error().message, HasSubstr("pieces"));
  EXPECT_FALSE(ltlf_goal(goal_of("(at-end (forall (?o - object) (dirty ?o)))"), three_mugs()));
  Trace many = three_mugs();
  for (int i = 0; i < 40; ++i) {
    many.entities.push_back({Entity::Kind::Object, "cup_" + std::to_string(i), "Cup", ""});
    many.states[0].set_exists(EntityIndex(many.entities.size() - 1));
  }
  const auto longest = ltlf_goal(goal_of("(at-end (count >= 20 (?c - Cup) (dirty ?c)))"), many);
  ASSERT_FALSE(longest);
  EXPECT_THAT(longest.error().message, HasSubstr("100,000"));
}

}  // namespace
}  // namespace unietp::testing
