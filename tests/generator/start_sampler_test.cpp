#include "generator/start_sampler.h"

#include <gtest/gtest.h>

#include "logic/evaluate.h"
#include "small_home.h"

namespace unietp {
namespace {

/// small_home with vessels that can be filled.
Knowledge home_with_vessels() {
  const auto bare = small_home(Simulator::Ai2thor);
  auto affordances = bare.affordances();
  for (const char* name : {"Bowl", "Mug", "Pot"}) affordances.push_back({name, "fillable", {"curated", 1}});
  return {Simulator::Ai2thor, bare.categories(), affordances, bare.placements(), bare.effects(), bare.aliases()};
}

/// Draws starts and holds each against the direct evaluator. Gives how many were found of `number`.
int found(const std::vector<std::string>& init, int number) {
  static const auto kKnowledge = home_with_vessels();
  Specification made;
  made.goal = *parse_formula("test", "(exists (?a - Mug) (at-end (held ?a)))", FormulaUse::Goal);
  for (const auto& text : init) {
    auto read = parse_formula("test", text, FormulaUse::State);
    EXPECT_TRUE(read) << format(read.error());
    made.init.push_back(*read);
  }
  const StartSampler sampler(made, kKnowledge);
  int starts = 0;
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(number); ++seed) {
    const auto start = sampler.sample(Rng(seed));
    if (!start) continue;
    ++starts;
    const auto trace = trace_of(start->setting, {start->world});
    for (const auto& constraint : made.init) EXPECT_TRUE(holds_in(constraint, trace, 0)) << to_text(constraint);
  }
  return starts;
}

TEST(StartSampler, MakesEveryShapeOfStartConstraint) {
  const std::vector<std::vector<std::string>> inits = {
      {"(forall (?a - Mug) (dirty ?a))", "(count >= 3 (?a - Mug) (exists (?b - Table) (on ?a ?b)))"},
      {"(count = 2 (?a - Mug) (and))", "(forall (?a - Mug) (filled ?a wine))"},
      {"(exists (?a - Mug) (filled ?a any))", "(exists (?a - Mug) (not (filled ?a any)))"},
      {"(forall (?a - Mug) (exists (?r - Kitchen) (on_floor ?a ?r)))"},
      {"(forall (?a - Mug) (not (exists (?r - Kitchen) (in_room ?a ?r))))"},
      {"(forall (?t - Table) (exists (?r - Kitchen) (in_room ?t ?r)))",
       "(count = 1 (?a - Mug) (exists (?t - Table) (on ?a ?t)))"},
      {"(exists (?a - Mug) (and (exists (?f - Fridge) (inside ?a ?f)) (hot ?a)))",
       "(forall (?f - Fridge) (closed ?f))"},
      {"(exists (?a - Mug) (exists (?b - Plate) (next_to ?a ?b)))"},
      {"(forall (?a - Mug) (not (exists (?b - Plate) (next_to ?a ?b))))"}};
  for (const auto& init : inits) EXPECT_EQ(found(init, 25), 25) << init.front();
}

TEST(StartSampler, FindsNothingWhereNothingIs) {
  EXPECT_EQ(found({"(forall (?a - Mug) (dirty ?a))", "(exists (?a - Mug) (clean ?a))"}, 3), 0);
}

TEST(StartSampler, AnAgentIsInNoRoomThatTheSpecificationNamesUnlessItSaysSo) {
  const auto away = "(forall (?r - Kitchen) (not (in_room agent ?r)))";
  const auto there = "(exists (?r - Kitchen) (in_room agent ?r))";
  EXPECT_EQ(found({away}, 20), 20);
  EXPECT_EQ(found({there}, 20), 20);
}

TEST(StartSampler, IsDeterministic) {
  const auto knowledge = home_with_vessels();
  Specification made;
  made.goal = *parse_formula("test", "(exists (?a - Mug) (at-end (hot ?a)))", FormulaUse::Goal);
  const StartSampler sampler(made, knowledge);
  for (std::uint64_t seed = 0; seed < 10; ++seed)
    EXPECT_EQ(sampler.sample(Rng(seed))->world, sampler.sample(Rng(seed))->world);
}

}  // namespace
}  // namespace unietp
