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

/// Two mugs and a plate, of which some are clean.
class CountingMonitor : public ::testing::Test {
 protected:
  void SetUp() override {
    for (std::size_t i = 0; i < entities_.size(); ++i) facts_.set_exists(EntityIndex(i));
  }
  void clean(std::size_t which) { facts_.set(Predicate::Clean, EntityIndex(which)); }

  EntityList entities_ = {{Entity::Kind::Object, "mug_1", "Mug", ""},
                          {Entity::Kind::Object, "mug_2", "Mug", ""},
                          {Entity::Kind::Object, "plate_1", "Plate", ""}};
  Facts facts_;
};

TEST_F(CountingMonitor, ProgressIsTheShareOfTheNumberThatIsNeeded) {
  clean(0);
  for (const auto& [goal, share] : {std::pair("(at-end (count >= 2 (?m - Mug) (clean ?m)))", 0.5),
                                    std::pair("(at-end (count > 1 (?m - Mug) (clean ?m)))", 0.5),
                                    std::pair("(at-end (count = 2 (?m - Mug) (clean ?m)))", 0.5)}) {
    Monitor monitor(goal_of(goal));
    monitor.observe(entities_, facts_);
    EXPECT_FALSE(monitor.satisfied()) << goal;
    EXPECT_DOUBLE_EQ(monitor.progress(), share) << goal;
  }
}

TEST_F(CountingMonitor, TwoNumbersAreComparedInWords) {
  clean(0);
  clean(2);
  Monitor monitor(goal_of("(at-end (count > (number (?m - Mug) (clean ?m)) (number (?p - Plate) (clean ?p))))"));
  monitor.observe(entities_, facts_);
  EXPECT_FALSE(monitor.satisfied());
  EXPECT_EQ(monitor.missing(), "counting Mug against Plate gives a difference of 0, it must be more than 0");
  clean(1);
  monitor.observe(entities_, facts_);
  EXPECT_TRUE(monitor.satisfied());
  EXPECT_EQ(monitor.missing(), "");
}

TEST_F(CountingMonitor, IsHopelessOnceTooFewAreLeft) {
  clean(0);
  clean(1);
  Monitor both(goal_of("(count >= 2 (?m - Mug) (always (clean ?m)))"));
  Monitor one(goal_of("(count >= 1 (?m - Mug) (always (clean ?m)))"));
  Monitor most(goal_of("(count <= 1 (?m - Mug) (sometime (dirty ?m)))"));
  for (Monitor* monitor : {&both, &one, &most}) {
    monitor->observe(entities_, facts_);
    EXPECT_TRUE(monitor->satisfied());
    EXPECT_FALSE(monitor->hopeless());
  }
  Facts dirty;
  for (std::size_t i = 0; i < entities_.size(); ++i) dirty.set_exists(EntityIndex(i));
  dirty.set(Predicate::Clean, EntityIndex(1));
  dirty.set(Predicate::Dirty, EntityIndex(0));
  for (Monitor* monitor : {&both, &one, &most}) monitor->observe(entities_, dirty);
  EXPECT_TRUE(both.hopeless());
  EXPECT_FALSE(one.hopeless());
  EXPECT_FALSE(most.hopeless());
  Facts all_dirty;
  for (std::size_t i = 0; i < entities_.size(); ++i) all_dirty.set_exists(EntityIndex(i));
  for (const std::size_t mug : {0U, 1U}) all_dirty.set(Predicate::Dirty, EntityIndex(mug));
  for (Monitor* monitor : {&both, &one, &most}) monitor->observe(entities_, all_dirty);
  EXPECT_TRUE(one.hopeless());
  EXPECT_TRUE(most.hopeless());
}

}  // namespace
}  // namespace unietp
