#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "generator/goal_parts.h"
#include "generator/specification.h"
#include "logic/evaluate.h"
#include "small_home.h"

namespace unietp {
namespace {

Specification made(const std::string& name, const Binding& binding, Simulator simulator = Simulator::Ai2thor) {
  auto result = instantiate(library_template(name), small_home(simulator), binding);
  EXPECT_TRUE(result) << format(result.error());
  return *result;
}

/// The `exists` with a `:where`, or nullptr.
const Formula* referring(const Formula& formula) {
  if (!formula.domain.where.empty()) return &formula;
  for (const auto& child : formula.children) {
    if (const auto* found = referring(child)) return found;
  }
  return nullptr;
}

/// How many objects of the first state the referring domain picks out, and how many of its category it excludes.
std::pair<std::size_t, std::size_t> picked_and_excluded(const Formula& quantifier, const Trace& start) {
  auto plain = quantifier.domain;
  plain.where.clear();
  const auto all = members_of(plain, quantifier.variable, start).size();
  const auto picked = members_of(quantifier.domain, quantifier.variable, start).size();
  return {picked, all - picked};
}

TEST(RefineReferring, PicksOutOneObjectAndExcludesADistractorInEveryStart) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  int refined_templates = 0;
  for (const auto& source : library()) {
    SCOPED_TRACE(source.name);
    std::size_t starts = 0;
    bool any = false;
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const auto plain = instantiate(source, knowledge, *sample_binding(source, knowledge, {}, Rng(seed)));
      ASSERT_TRUE(plain);
      const auto refined = refine_referring(*plain, knowledge, Rng(seed));
      if (!refined) continue;
      any = true;
      EXPECT_EQ(refined->split, Split::InstanceGrounding);
      EXPECT_TRUE(refined->refinement == "by-state" || refined->refinement == "by-place");
      const auto* quantifier = referring(refined->goal);
      ASSERT_NE(quantifier, nullptr);
      for (const auto& start : starts_by_rejection(*refined, knowledge, Rng(seed).fork("starts", 1), 2500)) {
        ++starts;
        const auto [picked, excluded] = picked_and_excluded(*quantifier, start);
        ASSERT_EQ(picked, 1U) << to_text(refined->goal);
        ASSERT_GE(excluded, 1U) << to_text(refined->goal);
        ASSERT_FALSE(holds(refined->goal, start));
        for (const auto& part : goal_parts(refined->goal)) ASSERT_FALSE(holds(part, start)) << to_text(part);
      }
    }
    refined_templates += any ? 1 : 0;
    EXPECT_TRUE(!any || starts >= 5U) << "too few random starts met the constraints for the test to say anything";
  }
  EXPECT_GE(refined_templates, 20);
}

TEST(RefineReferring, NeverRefersByAStateThatTheGoalChanges) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  const auto plain = made("wash-one", {{"A", "Mug"}, {"T", "Sink"}});
  std::set<std::string> wheres;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const auto refined = refine_referring(plain, knowledge, Rng(seed));
    ASSERT_TRUE(refined);
    wheres.insert(to_text(referring(refined->goal)->domain.where.front()));
  }
  EXPECT_FALSE(wheres.contains("(dirty ?a)"));
  EXPECT_TRUE(wheres.contains("(hot ?a)"));
  EXPECT_GT(wheres.size(), 2U) << "states and places both occur";
}

TEST(RefineReferring, NeverNamesThePlaceThatTheGoalIsAbout) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  const auto plain = made("place-one-on", {{"A", "Book"}, {"B", "Table"}});
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const auto refined = refine_referring(plain, knowledge, Rng(seed));
    ASSERT_TRUE(refined);
    EXPECT_EQ(refined->refinement, "by-place");  // a Book has no states here
    EXPECT_EQ(referring(refined->goal)->domain.where.front().domain.members[0].category == "Table", false);
  }
}

TEST(RefineReferring, KeepsToStatesThatTheSimulatorShows) {
  for (const auto simulator : {Simulator::Virtualhome, Simulator::Habitat}) {
    const auto knowledge = small_home(simulator);
    const auto plain = made("place-one-on", {{"A", "Mug"}, {"B", "Table"}}, simulator);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const auto refined = refine_referring(plain, knowledge, Rng(seed));
      ASSERT_TRUE(refined);
      EXPECT_EQ(refined->refinement, "by-place");
    }
  }
}

TEST(RefineReferring, LeavesGoalsAboutAllOrCountedObjectsAlone) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  for (const auto* name : {"wash-all", "open-all", "place-exactly-two-on", "place-one-on-each"}) {
    const auto& source = library_template(name);
    const auto plain = instantiate(source, knowledge, *sample_binding(source, knowledge, {}, Rng(1)));
    ASSERT_TRUE(plain);
    const auto refined = refine_referring(*plain, knowledge, Rng(1));
    if (refined) {  // then it refers to the receptacle, never to the counted objects
      EXPECT_NE(referring(refined->goal)->domain.members[0].category, plain->binding[0].second) << name;
    }
  }
}

TEST(RefineReferring, IsDeterministicAndDoesNotRefineTwice) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  const auto plain = made("place-one-on", {{"A", "Mug"}, {"B", "Table"}});
  const auto first = refine_referring(plain, knowledge, Rng(5));
  const auto second = refine_referring(plain, knowledge, Rng(5));
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->goal, second->goal);
  EXPECT_EQ(first->init, second->init);
  EXPECT_FALSE(refine_referring(*first, knowledge, Rng(5)));
}

TEST(RefineLinguistic, FunctionAcceptsEveryCategoryThatServes) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  const auto plain = made("place-one-on", {{"A", "Mug"}, {"B", "Table"}});
  bool seen = false;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const auto refined = refine_linguistic(plain, knowledge, Rng(seed));
    ASSERT_TRUE(refined);
    EXPECT_EQ(refined->split, Split::Linguistic);
    if (refined->style != "function") {
      EXPECT_EQ(refined->style, "alias");
      EXPECT_EQ(refined->goal, plain.goal);
      EXPECT_EQ(refined->init, plain.init);
      continue;
    }
    seen = true;
    EXPECT_EQ(to_text(refined->goal), "(exists (?a - (either Bowl Mug)) (exists (?b - Table) (at-end (on ?a ?b))))");
    for (const auto& start : starts_by_rejection(*refined, knowledge, Rng(seed), 500)) {
      ASSERT_FALSE(holds(refined->goal, start)) << "a Bowl on the Table would already do";
    }
  }
  EXPECT_TRUE(seen);
}

TEST(RefineLinguistic, ContextAndAliasKeepTheGoal) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  const auto plain = made("place-one-on", {{"A", "Apple"}, {"B", "Table"}});
  const auto refined = refine_linguistic(plain, knowledge, Rng(1));
  ASSERT_TRUE(refined);
  EXPECT_EQ(refined->style, "context");
  EXPECT_EQ(refined->goal, plain.goal);
}

TEST(RefineLinguistic, DoesNotApplyWithoutWordsForIt) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  EXPECT_FALSE(refine_linguistic(made("place-one-on", {{"A", "Plate"}, {"B", "Table"}}), knowledge, Rng(1)));
  EXPECT_FALSE(refine_linguistic(made("open-one", {{"A", "Fridge"}}), knowledge, Rng(1)));
}

}  // namespace
}  // namespace unietp
