// The orders in which an alternative's truths and moments are brought about.
#include "expert/ordering.h"

#include <algorithm>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/rng.h"
#include "tests/expert/house.h"

namespace unietp::testing {
namespace {

using ::testing::ElementsAre;

struct Ordering : ::testing::Test {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  const Scene start = house();
  const Formula formula = goal("(exists (?x - Mug) (at-end (held ?x)))");

  /// The order in which an expert with these preferences takes up literals that nothing makes true meanwhile.
  std::vector<std::string> order(const std::vector<std::vector<std::string>>& literals,
                                 const OrderPreferences& preferences = {}) {
    auto executions = ExecutionTree::of(formula, start, knowledge, profile);
    const Situation situation = look_around(*executions, Mode::M1);
    Alternative alternative;
    std::vector<Literal> open;
    for (const auto& words : literals) {
      Literal literal;
      for (const PredicateInfo& one : all_predicates()) {
        if (one.name == words.at(0)) literal.predicate = one.predicate;
      }
      literal.subject = *situation.find(words.at(1));
      if (words.size() > 2) literal.object = *situation.find(words[2]);
      open.push_back(literal);
    }
    std::sort(open.begin(), open.end());
    alternative.end = open;
    const Attempt attempt(*executions, situation, alternative, {});
    std::vector<std::string> taken;
    while (const auto next = next_literal(attempt, open, preferences)) {
      taken.push_back(to_text(*next, situation));
      std::erase(open, *next);
    }
    return taken;
  }
};

TEST_F(Ordering, CutsThenMovesThenSetsDoorsAndSwitches) {
  EXPECT_THAT(order({{"power_on", "television_1"},
                     {"closed", "fridge_1"},
                     {"open", "dresser_1"},
                     {"inside", "mug_1", "fridge_1"},
                     {"sliced", "apple_2"}}),
              ElementsAre("sliced(apple_2)", "inside(mug_1, fridge_1)", "open(dresser_1)", "power_on(television_1)"));
}

TEST_F(Ordering, WashesBeforeItHeatsAndHeatsBeforeItPutsDown) {
  EXPECT_THAT(order({{"on", "mug_1", "sidetable_1"}, {"hot", "mug_1"}, {"clean", "mug_1"}}),
              ElementsAre("clean(mug_1)", "hot(mug_1)", "on(mug_1, sidetable_1)"));
}

TEST_F(Ordering, WhatIsToStayInHandComesAfterWhatIsPutDown) {
  EXPECT_THAT(order({{"held", "mug_1"}, {"on", "plate_2", "diningtable_1"}}),
              ElementsAre("on(plate_2, diningtable_1)", "held(mug_1)"));
}

TEST_F(Ordering, ContentsComeBeforeWhatCarriesThem) {
  EXPECT_THAT(order({{"on", "plate_1", "sidetable_1"}, {"on", "mug_1", "plate_1"}}),
              ElementsAre("on(mug_1, plate_1)", "on(plate_1, sidetable_1)"));
}

TEST_F(Ordering, TheNearestComesFirstAndByAnotherHabitTheFarthestOrTheLargest) {
  const std::vector<std::vector<std::string>> moves{{"on", "plate_2", "countertop_1"},
                                                    {"on", "mug_1", "countertop_1"},
                                                    {"on", "box_1", "countertop_1"},
                                                    {"on", "mug_2", "countertop_1"}};
  EXPECT_THAT(order(moves), ElementsAre("on(box_1, countertop_1)", "on(mug_1, countertop_1)", "on(mug_2, countertop_1)",
                                        "on(plate_2, countertop_1)"));
  EXPECT_THAT(order(moves, {.far_first = true}), ElementsAre("on(plate_2, countertop_1)", "on(box_1, countertop_1)",
                                                             "on(mug_1, countertop_1)", "on(mug_2, countertop_1)"));
  EXPECT_THAT(order(moves, {.large_first = true}), ElementsAre("on(box_1, countertop_1)", "on(plate_2, countertop_1)",
                                                               "on(mug_1, countertop_1)", "on(mug_2, countertop_1)"));
}

TEST_F(Ordering, AThingIsSwitchedOnWhereItStandsUnlessTheHabitIsToDoItBefore) {
  const std::vector<std::vector<std::string>> lamp{{"power_on", "lamp_1"}, {"on", "lamp_1", "diningtable_1"}};
  EXPECT_THAT(order(lamp), ElementsAre("on(lamp_1, diningtable_1)", "power_on(lamp_1)"));
  EXPECT_THAT(order(lamp, {.switch_before_placing = true}),
              ElementsAre("power_on(lamp_1)", "on(lamp_1, diningtable_1)"));
  // Inside something it may be out of reach.
  EXPECT_THAT(order({{"power_on", "lamp_1"}, {"inside", "lamp_1", "fridge_1"}}),
              ElementsAre("power_on(lamp_1)", "inside(lamp_1, fridge_1)"));
}

Alternative with_moments(const std::vector<std::vector<std::size_t>>& after) {
  Alternative alternative;
  for (const auto& earlier : after) {
    Moment moment;
    moment.after = earlier;
    alternative.moments.push_back(std::move(moment));
  }
  return alternative;
}

TEST(OrderOfMoments, FollowsTheArrowsAndElseTheListOrByHabitItsReverse) {
  const auto moments = with_moments({{2}, {}, {}, {0, 1}});
  EXPECT_THAT(order_of_moments(moments, {}), ElementsAre(1, 2, 0, 3));
  EXPECT_THAT(order_of_moments(moments, {.far_first = true}), ElementsAre(2, 1, 0, 3));
}

TEST(OrderOfMoments, HasEachOnceAfterAllThatItWaitsForForAnySeed) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const std::size_t n = rng.below(8);
    std::vector<std::size_t> places(n);  // an arrow runs only from an earlier to a later place
    std::iota(places.begin(), places.end(), std::size_t{0});
    rng.shuffle(places);
    std::vector<std::vector<std::size_t>> after(n);
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = 0; b < n; ++b) {
        if (places[b] < places[a] && rng.chance(0.4)) after[a].push_back(b);
      }
    }
    for (const bool far_first : {false, true}) {
      const auto order = order_of_moments(with_moments(after), {.far_first = far_first});
      ASSERT_EQ(order.size(), n);
      for (std::size_t i = 0; i < n; ++i) {
        for (const std::size_t earlier : after[order[i]])
          EXPECT_NE(std::find(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(i), earlier),
                    order.begin() + static_cast<std::ptrdiff_t>(i));
      }
    }
  }
}

}  // namespace
}  // namespace unietp::testing
