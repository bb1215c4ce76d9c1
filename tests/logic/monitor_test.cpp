#include "logic/monitor.h"

#include <gtest/gtest.h>

#include "logic/evaluate.h"
#include "random_goals.h"

namespace unietp {
namespace {

using testing::goal_of;
using testing::GoalWriter;
using testing::prefix_of;
using testing::random_trace;

// Three twins read the same random goals and traces: the evaluator, the monitor fed one state at a time, and a copy of
// the monitor taken midway.
TEST(Monitor, AgreesWithTheEvaluatorAtEveryPrefixOfRandomTraces) {
  constexpr std::uint64_t kPairs = 100000;
  std::uint64_t goals_true = 0, readings = 0, hopeless = 0, changed_midway = 0;
  for (std::uint64_t seed = 0; seed < kPairs; ++seed) {
    GoalWriter writer(Rng(seed).fork("goal", 0));
    const Formula goal = writer.goal();
    const Trace trace = random_trace(Rng(seed).fork("trace", 0));
    Monitor monitor(goal);
    bool was_hopeless = false, expected = false, first = false;
    for (std::size_t length = 1; length <= trace.states.size(); ++length) {
      const Trace prefix = prefix_of(trace, length);
      if (length == 2) {
        const Monitor copy = monitor;
        monitor = copy;
      }
      monitor.observe(prefix.entities, prefix.states.back());
      expected = holds(goal, prefix);
      if (length == 1) first = expected;
      ASSERT_EQ(monitor.satisfied(), expected)
          << "seed " << seed << ", after " << length << " of " << trace.states.size() << " states: " << to_text(goal);
      ASSERT_FALSE(was_hopeless && expected) << "called hopeless too early, seed " << seed << ": " << to_text(goal);
      was_hopeless = was_hopeless || monitor.hopeless();
      const double progress = monitor.progress();
      ASSERT_EQ(progress == 1.0, expected) << "seed " << seed << ": " << to_text(goal);
      ASSERT_TRUE(progress >= 0 && progress <= 1) << progress;
      ASSERT_EQ(monitor.missing().empty(), expected) << "seed " << seed << ": " << to_text(goal);
      ++readings;
    }
    goals_true += expected ? 1 : 0;
    hopeless += was_hopeless ? 1 : 0;
    changed_midway += first != expected ? 1 : 0;
  }
  EXPECT_GT(goals_true, kPairs / 5) << "the random goals are too seldom true to test anything";
  EXPECT_LT(goals_true, kPairs - kPairs / 5) << "the random goals are too seldom false to test anything";
  EXPECT_GT(hopeless, kPairs / 50);
  EXPECT_GT(changed_midway, kPairs / 20) << "the truth of too few goals depends on more than the first state";
  EXPECT_GT(readings, 2 * kPairs);
}

TEST(Monitor, SaysHowMuchIsMetAndWhatIsMissing) {
  const Formula goal = goal_of("(exists (?x - Mug) (exists (?t - Table) (at-end (and (on ?x ?t) (hot ?x)))))");
  Trace trace;
  trace.entities = {{Entity::Kind::Object, "mug_1", "Mug", ""}, {Entity::Kind::Object, "table_2", "Table", ""}};
  Facts facts;
  facts.set_exists(EntityIndex(0));
  facts.set_exists(EntityIndex(1));
  Monitor monitor(goal);
  EXPECT_EQ(monitor.progress(), 0);
  EXPECT_FALSE(monitor.satisfied());
  EXPECT_EQ(monitor.missing(), "no state has been observed yet");
  monitor.observe(trace.entities, facts);
  EXPECT_EQ(monitor.progress(), 0);
  EXPECT_EQ(monitor.missing(), "mug_1 is not on table_2; mug_1 is not hot");
  facts.set(Predicate::Hot, EntityIndex(0));
  monitor.observe(trace.entities, facts);
  EXPECT_EQ(monitor.progress(), 0.5);
  EXPECT_EQ(monitor.missing(), "mug_1 is not on table_2");
  facts.set(Predicate::On, EntityIndex(0), EntityIndex(1));
  monitor.observe(trace.entities, facts);
  EXPECT_EQ(monitor.progress(), 1);
  EXPECT_EQ(monitor.missing(), "");
}

}  // namespace
}  // namespace unietp
