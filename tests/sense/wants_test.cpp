#include "sense/wants.h"

#include <gtest/gtest.h>

namespace unietp {
namespace {

Wants read(const std::string& goal) {
  const auto formula = parse_formula("goal", goal, FormulaUse::Goal);
  EXPECT_TRUE(formula) << (formula ? "" : format(formula.error()));
  return wants_of(*formula);
}

std::vector<Predicate> predicates(const Wants& wants) {
  std::vector<Predicate> all;
  for (const auto& want : wants.wants) all.push_back(want.predicate);
  return all;
}

TEST(Wants, ComeInTheOrderOfTheGoalAndOnce) {
  const auto wants = read(
      "(exists (?a - Mug) (exists (?b - Desk) (and (before (clean ?a) (on ?a ?b)) (at-end (and (clean ?a) (on ?a "
      "?b))))))");
  EXPECT_EQ(predicates(wants), (std::vector{Predicate::Clean, Predicate::On}));
  ASSERT_EQ(wants.things.size(), 2u);
  EXPECT_EQ(wants.wants[1].other, 1u);
}

TEST(Wants, LeaveOutWhatIsForbiddenKeptOrAssumed) {
  EXPECT_EQ(predicates(read("(exists (?a - Mug) (exists (?b - Desk) (exists (?c - Fridge) (and (until (closed ?c) (on "
                            "?a ?b)) (always (closed ?c)) (at-end (on ?a ?b))))))")),
            (std::vector{Predicate::On}));
  const auto cleared = read("(exists (?b - Desk) (at-end (count = 0 (?a - Mug) (on ?a ?b))))");
  ASSERT_EQ(cleared.wants.size(), 1u);
  EXPECT_TRUE(cleared.wants.front().negated);
  EXPECT_TRUE(read("(exists (?b - Desk) (at-end (count <= 1 (?a - Mug) (on ?a ?b))))").wants.empty());
}

TEST(Wants, WhatIsSwitchedOffAgainIsNotLeftOn) {
  EXPECT_EQ(predicates(read("(exists (?a - Stove) (and (sometime (power_on ?a)) (at-end (power_off ?a))))")),
            (std::vector{Predicate::PowerOff}));
  EXPECT_EQ(predicates(read("(exists (?a - Stove) (exists (?b - Stove) (and (at-end (power_on ?a)) (at-end (power_off "
                            "?b)))))")),
            (std::vector{Predicate::PowerOn, Predicate::PowerOff}));
}

TEST(Wants, CountsAskForTheirBody) {
  EXPECT_EQ(predicates(read("(exists (?b - Desk) (at-end (count >= 2 (?a - Mug) (on ?a ?b))))")),
            (std::vector{Predicate::On}));
}

TEST(Wants, WhereSaysWhereThingsAreFound) {
  const auto wants =
      read("(exists (?a - (Tomato :where (exists (?b - GarbageCan) (inside ?a ?b)))) (at-end (sliced ?a)))");
  EXPECT_EQ(predicates(wants), (std::vector{Predicate::Sliced}));
  ASSERT_EQ(wants.found.size(), 1u);
  EXPECT_EQ(wants.found.front().predicate, Predicate::Inside);
  EXPECT_EQ(wants.things[*wants.found.front().other].members.front().category, "GarbageCan");
}

TEST(Wants, WhereSaysWhatThingsAreNearAndThatTheyAreDirty) {
  const auto wants = read(
      "(exists (?a - (Mug :where (and (dirty ?a) (hot ?a) (not (open ?a)) (exists (?b - Bed) (nearest ?a ?b))))) "
      "(at-end (clean ?a)))");
  ASSERT_EQ(wants.found.size(), 2u) << "other states tell things apart, too, but nobody minds them";
  EXPECT_EQ(wants.found[0].predicate, Predicate::Dirty);
  EXPECT_EQ(wants.found[1].predicate, Predicate::Nearest);
}

TEST(Wants, SaysOfWhatOneIsEnough) {
  const auto single = [](const std::string& goal) { return read(goal).single; };
  EXPECT_EQ(single("(exists (?a - Mug) (forall (?b - Plate) (at-end (next_to ?a ?b))))"), (std::vector{true, false}));
  EXPECT_EQ(single("(at-end (count = 1 (?a - Mug) (held ?a)))"), (std::vector{true}));
  EXPECT_EQ(single("(at-end (count > 1 (?a - Mug) (hot ?a)))"), (std::vector{false}));
  EXPECT_EQ(single("(at-end (count = 0 (?a - Mug) (hot ?a)))"), (std::vector{false})) << "none, not one";
}

TEST(Wants, TheAgentMayBeWhatMoves) {
  EXPECT_TRUE(read("(exists (?r - kitchen) (at-end (in_room agent ?r)))").moves_agent);
  EXPECT_FALSE(read("(exists (?a - Mug) (at-end (held ?a)))").moves_agent);
}

}  // namespace
}  // namespace unietp
