#include "annotator/equivalence.h"

#include <gtest/gtest.h>

#include "../logic/random_goals.h"
#include "annotator/meaning.h"
#include "goal_mutations.h"
#include "logic/evaluate.h"

namespace unietp {
namespace {

Formula goal(const char* text) {
  const auto parsed = parse_formula("test", text, FormulaUse::Goal);
  EXPECT_TRUE(parsed) << format(parsed.error());
  return parsed ? *parsed : Formula{};
}

bool distinguishable(const char* left, const char* right) {
  return distinguishing_trace(goal(left), goal(right), kTracesCompared, Rng(1)).has_value();
}

TEST(Equivalent, LooksThroughNamesOrderAndCountIdentities) {
  const std::pair<const char*, const char*> pairs[] = {
      {"(exists (?a - Mug) (exists (?b - Table) (at-end (on ?a ?b))))",
       "(at-end (count >= 1 (?y - Table) (exists (?x - Mug) (on ?x ?y))))"},
      {"(forall (?a - Mug) (at-end (clean ?a)))", "(at-end (not (exists (?a - Mug) (not (clean ?a)))))"},
      {"(exists (?b - Box) (at-end (count = 2 (?a - Mug) (inside ?a ?b))))",
       "(exists (?b - Box) (at-end (and (count > 1 (?a - Mug) (inside ?a ?b)) (count < 3 (?a - Mug) (inside ?a "
       "?b)))))"},
      {"(exists (?b - Box) (at-end (closed ?b)))", "(exists (?b - Box) (at-end (not (open ?b))))"},
      {"(exists (?b - Box) (always (closed ?b)))", "(exists (?b - Box) (not (sometime (open ?b))))"},
      {"(exists (?a - (Mug :where (dirty ?a))) (at-end (clean ?a)))",
       "(exists (?a - (Mug :where (not (clean ?a)))) (at-end (clean ?a)))"},
      {"(forall (?a - Mug) (imply (at-end (hot ?a)) (at-end (clean ?a))))",
       "(forall (?a - Mug) (at-end (or (not (hot ?a)) (clean ?a))))"},
  };
  for (const auto& [left, right] : pairs) {
    EXPECT_TRUE(equivalent(goal(left), goal(right))) << left << "\n" << right;
    EXPECT_FALSE(distinguishable(left, right)) << left << "\n" << right;
  }
}

TEST(Equivalent, TellsNearMissesApart) {
  const std::pair<const char*, const char*> pairs[] = {
      {"(forall (?a - Mug) (exists (?b - Table) (at-end (on ?a ?b))))",
       "(exists (?b - Table) (forall (?a - Mug) (at-end (on ?a ?b))))"},
      {"(exists (?b - Box) (at-end (count = 2 (?a - Mug) (inside ?a ?b))))",
       "(exists (?b - Box) (at-end (count >= 2 (?a - Mug) (inside ?a ?b))))"},
      {"(exists (?b - Box) (at-end (count >= 5 (?a - Mug) (inside ?a ?b))))",
       "(exists (?b - Box) (at-end (count >= 4 (?a - Mug) (inside ?a ?b))))"},
      {"(exists (?b - Box) (before (open ?b) (clean ?b)))", "(exists (?b - Box) (before (clean ?b) (open ?b)))"},
      {"(exists (?b - Box) (until (open ?b) (clean ?b)))", "(exists (?b - Box) (sometime (clean ?b)))"},
      {"(exists (?b - Box) (and (sometime (open ?b)) (at-end (closed ?b))))",
       "(exists (?b - Box) (at-end (closed ?b)))"},
      {"(exists (?a - Mug) (at-end (filled ?a water)))", "(exists (?a - Mug) (at-end (filled ?a milk)))"},
      {"(exists (?a - Mug) (at-end (hot ?a)))", "(exists (?a - (either Mug Cup)) (at-end (hot ?a)))"},
      {"(exists (?a - Apple/slice) (at-end (hot ?a)))", "(exists (?a - Apple) (at-end (hot ?a)))"},
      {"(exists (?a - (Mug :where (exists (?t - Table) (on ?a ?t)))) (at-end (hot ?a)))",
       "(exists (?a - Mug) (at-end (hot ?a)))"},
      {"(exists (?r - Kitchen) (at-end (in_room agent ?r)))", "(exists (?r - Bedroom) (at-end (in_room agent ?r)))"},
      {"(exists (?a - Mug) (exists (?b - Mug) (at-end (and (not (= ?a ?b)) (hot ?a) (hot ?b)))))",
       "(exists (?a - Mug) (exists (?b - Mug) (at-end (and (hot ?a) (hot ?b)))))"},
  };
  for (const auto& [left, right] : pairs) {
    EXPECT_FALSE(equivalent(goal(left), goal(right))) << left << "\n" << right;
    EXPECT_TRUE(distinguishable(left, right)) << left << "\n" << right;
  }
}

TEST(Equivalent, ATellingTraceTells) {
  const Formula left = goal("(exists (?a - Mug) (at-end (hot ?a)))"),
                right = goal("(forall (?a - Mug) (at-end (hot ?a)))");
  const auto trace = distinguishing_trace(left, right, kTracesCompared, Rng(3));
  ASSERT_TRUE(trace);
  EXPECT_NE(holds(left, *trace), holds(right, *trace));
}

/// The proof by structure and the evaluation are two ways to one answer.
TEST(Equivalent, WhatIsProvenEqualIsNeverToldApart) {
  int proven = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Formula left = ::unietp::testing::GoalWriter(Rng(seed)).goal();
    Rng rng(seed);
    for (const Formula& right : {expanded(left), testing_support::rewritten(left, rng)}) {
      if (!same_meaning(left, right)) continue;
      ++proven;
      EXPECT_FALSE(distinguishing_trace(left, right, 200, Rng(seed))) << to_text(left) << "\n" << to_text(right);
    }
  }
  EXPECT_GT(proven, 300);
}

}  // namespace
}  // namespace unietp
