#include "scene/states.h"

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "core/rng.h"

namespace unietp {
namespace {

State any_state(Rng& rng) {
  const auto predicate = all_predicates()[rng.below(static_cast<std::size_t>(Predicate::Covered) + 1)].predicate;
  const bool symbolic = predicate == Predicate::Filled || predicate == Predicate::Covered;
  return {predicate, symbolic ? (rng.chance(0.5) ? "water" : "wine") : ""};
}

TEST(States, NoPredicateIsInTwoGroupsAndEachGroupHasAChoice) {
  std::map<Predicate, std::string> group_of;
  for (const StateGroup& group : state_groups()) {
    EXPECT_GE(group.predicates.size(), 2u);
    for (const Predicate p : group.predicates)
      EXPECT_TRUE(group_of.emplace(p, group.affordance).second) << info(p).name;
  }
}

TEST(States, TheDefaultComesFirstInItsGroup) {
  for (const StateGroup& group : state_groups()) {
    for (const Predicate p : group.predicates) EXPECT_EQ(info(p).by_default, p == group.predicates.front());
  }
}

TEST(States, AnOppositeIsMutualAndOnlyOfGroupsOfTwoPlainStates) {
  EXPECT_EQ(opposite_of(Predicate::Open), Predicate::Closed);
  EXPECT_EQ(opposite_of(Predicate::Closed), Predicate::Open);
  EXPECT_EQ(opposite_of(Predicate::Hot), std::nullopt);
  EXPECT_EQ(opposite_of(Predicate::Empty), std::nullopt);
  EXPECT_EQ(opposite_of(Predicate::On), std::nullopt);
  for (const PredicateInfo& row : all_predicates()) {
    const auto other = opposite_of(row.predicate);
    EXPECT_TRUE(!other || opposite_of(*other) == row.predicate) << row.name;
  }
}

TEST(States, SettingOneOfAGroupTakesTheOthersAway) {
  StateSet states;
  states.set({Predicate::Cool, ""});
  states.set({Predicate::Clean, ""});
  states.set({Predicate::Hot, ""});
  EXPECT_TRUE(states.has(Predicate::Hot));
  EXPECT_FALSE(states.has(Predicate::Cool));
  EXPECT_TRUE(states.has(Predicate::Clean));
}

TEST(States, AVesselHoldsOneLiquidButASurfaceMayBeCoveredTwice) {
  StateSet states;
  states.set({Predicate::Filled, "water"});
  states.set({Predicate::Filled, "coffee"});
  states.set({Predicate::Covered, "dust"});
  states.set({Predicate::Covered, "stain"});
  EXPECT_FALSE(states.has(State{Predicate::Filled, "water"}));
  EXPECT_TRUE(states.has(State{Predicate::Filled, "coffee"}));
  EXPECT_TRUE(states.has(State{Predicate::Covered, "dust"}));
  EXPECT_TRUE(states.has(State{Predicate::Covered, "stain"}));
  states.set({Predicate::Empty, ""});
  EXPECT_FALSE(states.has(Predicate::Filled));
  states.clear(Predicate::Covered);
  EXPECT_EQ(states.all(), (std::vector<State>{{Predicate::Empty, ""}}));
}

TEST(States, AreSortedAndExclusiveAndDoNotDependOnTheOrderOfUnrelatedSettingsForAnySeed) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    StateSet states;
    std::vector<State> last;  // the oracle: the last setting of each group, and every ungrouped one
    for (int i = 0; i < 25; ++i) {
      const State state = any_state(rng);
      states.set(state);
      std::erase_if(last, [&](const State& other) {
        if (other == state) return true;
        return std::any_of(state_groups().begin(), state_groups().end(), [&](const StateGroup& group) {
          const auto in = [&](Predicate p) {
            return std::find(group.predicates.begin(), group.predicates.end(), p) != group.predicates.end();
          };
          return in(state.predicate) && in(other.predicate);
        });
      });
      last.push_back(state);
    }
    std::sort(last.begin(), last.end());
    EXPECT_EQ(states.all(), last);
    for (const State& state : last) EXPECT_TRUE(states.has(state) && states.has(state.predicate));
  }
}

}  // namespace
}  // namespace unietp
