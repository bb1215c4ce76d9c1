#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "generator/fixed_start.h"
#include "generator/goal_parts.h"
#include "generator/place_in_room.h"
#include "generator/specification.h"
#include "generator/style_fit.h"
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

/// What the referring domain of a quantifier has to pick out: one for `exists`; of a `forall` or count several.
bool enough(const Formula& quantifier, std::size_t picked) {
  return quantifier.op == Formula::Op::Exists ? picked == 1 : picked >= 2;
}

/// Those whose `:where` speaks of no outer variable.
void collect_referring(const Formula& formula, std::vector<const Formula*>& found) {
  const auto& where = formula.domain.where;
  if (!where.empty() && free_variables(where.front()) == std::vector{formula.variable}) found.push_back(&formula);
  for (const auto& child : formula.children) collect_referring(child, found);
}

/// A home in which there is something to refer by: rooms and landmarks that it has once, and what a start asks for.
SceneOffer offer_with(const std::vector<std::string>& categories) {
  SceneOffer offer;
  Facts facts;
  const auto add = [&](const std::string& name, Entity::Kind kind) {
    facts.set_exists(EntityIndex(offer.now.entities.size()));
    offer.now.entities.push_back({kind, name + std::to_string(offer.now.entities.size()), name, ""});
  };
  for (const auto* room : {"Kitchen", "LivingRoom"}) add(room, Entity::Kind::Room);
  for (const auto& name : categories) add(name, Entity::Kind::Object);
  offer.now.states.push_back(facts);
  return offer;
}

/// Everything stands in the kitchen, and each thing is the nearest of its kind to any other.
SceneOffer small_offer() {
  auto offer = offer_with(
      {"Lamp", "Television", "Counter", "Table", "Shelf", "Sink", "Fridge", "Cabinet", "Bowl", "Book", "Mug", "Mug"});
  Facts& facts = offer.now.states[0];
  for (std::size_t i = 2; i < offer.now.entities.size(); ++i) {
    facts.set(Predicate::InRoom, EntityIndex(i), EntityIndex(0));
    for (std::size_t k = 2; k < offer.now.entities.size(); ++k)
      if (k != i) facts.set(Predicate::Nearest, EntityIndex(i), EntityIndex(k));
  }
  return offer;
}

class ReferringKind : public ::testing::TestWithParam<std::string> {};

TEST_P(ReferringKind, SinglesOutWhatIsMeantAndLeavesADistractorInEveryStart) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  std::size_t starts = 0, refined_goals = 0;
  for (const auto& source : library()) {
    if (!supports(source, Simulator::Ai2thor) || !source.refinement.empty()) continue;
    SCOPED_TRACE(source.name);
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      const auto binding = sample_binding(source, knowledge, {}, Rng(seed).fork(source.name, 0));
      if (!binding) break;
      const auto plain = instantiate(source, knowledge, *binding);
      ASSERT_TRUE(plain);
      const auto refined = refine_referring(*plain, knowledge, small_offer(), GetParam(), Rng(seed));
      if (!refined) continue;
      ++refined_goals;
      EXPECT_EQ(refined->split, Split::InstanceGrounding);
      EXPECT_EQ(name_of(refined->refinement), GetParam());
      std::vector<const Formula*> quantifiers, own;
      collect_referring(refined->goal, quantifiers);
      collect_referring(plain->goal, own);
      std::erase_if(quantifiers, [&](const Formula* one) {  // what the template singles out itself
        return std::any_of(own.begin(), own.end(), [&](const Formula* other) { return other->domain == one->domain; });
      });
      ASSERT_EQ(quantifiers.size(), GetParam() == "each-its-own" ? 2U : 1U) << to_text(refined->goal);
      for (const auto& start : starts_by_rejection(*refined, knowledge, Rng(seed).fork("starts", 1), 300)) {
        ++starts;
        for (const auto* quantifier : quantifiers) {
          const auto [picked, excluded] = picked_and_excluded(*quantifier, start);
          ASSERT_TRUE(enough(*quantifier, picked)) << picked << " of " << to_text(refined->goal);
          ASSERT_GE(excluded, 1U) << to_text(refined->goal);
        }
        ASSERT_FALSE(holds(refined->goal, start));
        for (const auto& part : goal_parts(refined->goal)) ASSERT_FALSE(holds(part, start)) << to_text(part);
      }
    }
  }
  EXPECT_GE(refined_goals, 5U);
  EXPECT_GE(starts, 5U) << "too few random starts met the constraints for the test to say anything";
}

INSTANTIATE_TEST_SUITE_P(All, ReferringKind,
                         ::testing::Values("by-state", "by-relation", "by-room", "by-nearness", "by-size",
                                           "by-attribute", "by-two", "each-its-own"),
                         [](const auto& parameter) {
                           std::string name = parameter.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST(RefineReferring, ChoosesAmongAllKindsWhenNoneIsAskedFor) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  const auto plain = made("place-one-on", {{"A", "Mug"}, {"B", "Table"}});
  std::set<std::string> kinds;
  for (std::uint64_t seed = 0; seed < 80; ++seed) {
    if (const auto refined = refine_referring(plain, knowledge, small_offer(), "", Rng(seed))) {
      kinds.emplace(name_of(refined->refinement));
    }
  }
  EXPECT_EQ(kinds, (std::set<std::string>{"by-attribute", "by-nearness", "by-relation", "by-room", "by-size",
                                          "by-state", "by-two"}));
}

TEST(RefineReferring, AColorLeavesNothingThatCouldBeTakenForIt) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  const auto plain = made("place-one-on", {{"A", "Mug"}, {"B", "Table"}});
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto refined = refine_referring(plain, knowledge, {}, "by-attribute", Rng(seed));
    ASSERT_TRUE(refined);
    const auto said = to_text(referring(refined->goal)->domain.where.front());
    std::set<std::string> starts;
    for (const auto& start : refined->init) starts.insert(to_text(start));
    EXPECT_TRUE(starts.contains("(forall (?a - Mug) (colour ?a any))"));
    EXPECT_EQ(starts.contains("(forall (?a - Mug) (not (colour ?a orange)))"), said == "(colour ?a red)") << said;
  }
}

TEST(RefineReferring, ARoomIsReferredByOnlyIfTheStartHasOneOfItsType) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  const auto plain = made("place-one-on", {{"A", "Mug"}, {"B", "Table"}});
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const auto refined = refine_referring(plain, knowledge, small_offer(), "by-room", Rng(seed));
    ASSERT_TRUE(refined);
    const auto& room = referring(refined->goal)->domain.where.front().domain;
    EXPECT_TRUE(std::any_of(refined->init.begin(), refined->init.end(), [&](const Formula& start) {
      return start.op == Formula::Op::Count && start.comparison == Comparison::Equal && start.number == 1 &&
             start.domain == room;
    })) << to_text(refined->goal);
  }
}

TEST(RefineReferring, WhatCannotBeMovedIsReferredToOnlyAsTheHomeHasIt) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  const auto plain = made("open-one", {{"A", "Fridge"}});
  EXPECT_FALSE(refine_referring(plain, knowledge, offer_with({"Fridge", "Table"}), "by-room", Rng(1)));
  auto two = offer_with({"Fridge", "Fridge", "Table"});
  two.now.states[0].set(Predicate::InRoom, EntityIndex(2), EntityIndex(0));
  two.now.states[0].set(Predicate::InRoom, EntityIndex(3), EntityIndex(1));
  const auto refined = refine_referring(plain, knowledge, two, "by-room", Rng(1));
  ASSERT_TRUE(refined);
  EXPECT_EQ(referring(refined->goal)->domain.where.front().domain.members.size(), 1U);
}

/// Two tables in the kitchen and one in the living room.
SceneOffer three_tables() {
  auto offer = offer_with({"Table", "Table", "Table", "Mug"});
  Facts& facts = offer.now.states[0];
  for (const std::size_t in_kitchen : {2U, 3U, 5U})
    facts.set(Predicate::InRoom, EntityIndex(in_kitchen), EntityIndex(0));
  facts.set(Predicate::InRoom, EntityIndex(4), EntityIndex(1));
  return offer;
}

constexpr auto kAnyRoom = [](const std::string&, const std::string&) { return true; };

TEST(PlaceInRoom, IsThePlaceOfARoomThatSuitsAndRatherOneThatHasOne) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  const auto plain = made("place-one-on", {{"A", "Mug"}, {"B", "Table"}});
  const auto only_kitchen = [](const std::string&, const std::string& room) { return room == "Kitchen"; };
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const auto any = with_places_in_rooms(plain, knowledge, three_tables(), kAnyRoom, Rng(seed));
    EXPECT_NE(to_text(any.goal).find("(Table :where (exists (?p - LivingRoom) (in_room ?b ?p)))"), std::string::npos)
        << to_text(any.goal);
    const auto kitchen = with_places_in_rooms(plain, knowledge, three_tables(), only_kitchen, Rng(seed));
    EXPECT_NE(to_text(kitchen.goal).find("(Table :where (exists (?p - Kitchen)"), std::string::npos);
    EXPECT_TRUE(std::any_of(kitchen.init.begin(), kitchen.init.end(),
                            [](const Formula& start) { return to_text(start) == "(count = 1 (?p - Kitchen) (and))"; }));
    EXPECT_EQ(kitchen.split, plain.split);
    EXPECT_EQ(kitchen.refinement, plain.refinement);
  }
}

TEST(PlaceInRoom, IsNotAddedWhereItSaysNothingOrSuitsNothing) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  const auto plain = made("place-one-on", {{"A", "Mug"}, {"B", "Table"}});
  const auto no_room = [](const std::string&, const std::string&) { return false; };
  EXPECT_EQ(with_places_in_rooms(plain, knowledge, three_tables(), no_room, Rng(1)).goal, plain.goal);
  EXPECT_EQ(with_places_in_rooms(plain, knowledge, SceneOffer(), kAnyRoom, Rng(1)).goal, plain.goal);
  auto together = three_tables();  // all three in the kitchen
  together.now.states[0] = offer_with({"Table", "Table", "Table", "Mug"}).now.states[0];
  for (const std::size_t table : {2U, 3U, 4U})
    together.now.states[0].set(Predicate::InRoom, EntityIndex(table), EntityIndex(0));
  EXPECT_EQ(with_places_in_rooms(plain, knowledge, together, kAnyRoom, Rng(1)).goal, plain.goal);
  auto by_room = plain;
  by_room.refinement = Referring::ByRoom;
  EXPECT_EQ(with_places_in_rooms(by_room, knowledge, three_tables(), kAnyRoom, Rng(1)).goal, plain.goal);
}

TEST(PlaceInRoom, IsWhereSomethingIsCoveredAndNothingElseIs) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  auto plain = made("place-one-on", {{"A", "Mug"}, {"B", "Table"}});
  plain.init.push_back(*parse_formula("test", "(forall (?b - Table) (covered ?b dust))", FormulaUse::State));
  plain.init.push_back(*parse_formula("test", "(forall (?b - Table) (dirty ?b))", FormulaUse::State));
  const auto named = with_places_in_rooms(plain, knowledge, three_tables(), kAnyRoom, Rng(1));
  const auto covered = [](const Formula& start) {
    return to_text(start) ==
           "(forall (?b - Table) (or (not (exists (?p - LivingRoom) (in_room ?b ?p))) (covered ?b dust)))";
  };
  EXPECT_TRUE(std::any_of(named.init.begin(), named.init.end(), covered));
  for (const Formula& start : named.init)
    EXPECT_TRUE(parse_formula("test", to_text(start), FormulaUse::State)) << "validate reads it";
  const auto all_dirty = [](const Formula& start) { return to_text(start) == "(forall (?b - Table) (dirty ?b))"; };
  EXPECT_TRUE(std::any_of(named.init.begin(), named.init.end(), all_dirty)) << "many things are dirty in a home";
}

TEST(PlaceInRoom, IsFoundAgainInTheGoal) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  const auto plain = made("place-one-on", {{"A", "Mug"}, {"B", "Table"}});
  const auto named = with_places_in_rooms(plain, knowledge, three_tables(), kAnyRoom, Rng(1));
  const auto places = places_in_rooms(named.goal, Referring::None, plain.goal, knowledge);
  ASSERT_EQ(places.size(), 1U);
  EXPECT_EQ(places[0].variable, "b");
  const auto again = with_place_in_room(plain, places[0]);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->goal, named.goal);
  EXPECT_EQ(again->init, named.init);
  EXPECT_TRUE(places_in_rooms(named.goal, Referring::ByRoom, plain.goal, knowledge).empty()) << "it is the reference";
  EXPECT_TRUE(places_in_rooms(plain.goal, Referring::None, plain.goal, knowledge).empty());
}

TEST(Misfit, IsWhatFurnitureAndRoomsLackNotWhatAnEditOfTheStartGives) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  std::vector<Formula> init;
  const auto fits = [&](const char* start, const Trace& now) {
    const auto formula = parse_formula("test", start, FormulaUse::State);
    EXPECT_TRUE(formula) << start;
    init = {*formula};
    const auto* found = misfit(init, knowledge, now);
    EXPECT_TRUE(found == nullptr || found == init.data());
    return found == nullptr;
  };
  auto offer = offer_with({"Fridge", "Fridge", "Table", "Mug"});
  offer.now.states[0].set(Predicate::InRoom, EntityIndex(2), EntityIndex(0));
  offer.now.states[0].set(Predicate::InRoom, EntityIndex(3), EntityIndex(1));
  const auto& two = offer.now;
  EXPECT_TRUE(fits("(count = 1 (?a - Fridge) (exists (?r - Kitchen) (in_room ?a ?r)))", two));
  EXPECT_FALSE(fits("(count = 2 (?a - Fridge) (exists (?r - Kitchen) (in_room ?a ?r)))", two));
  EXPECT_FALSE(fits("(count >= 2 (?a - Fridge) (and (open ?a) (exists (?r - Kitchen) (in_room ?a ?r))))", two))
      << "opening another one elsewhere does not help";
  EXPECT_FALSE(fits("(count = 1 (?a - Fridge) (and))", two)) << "none is taken out";
  EXPECT_FALSE(fits("(count >= 3 (?a - Fridge) (and))", two)) << "none is set up beside them";
  EXPECT_TRUE(fits("(count = 1 (?a - Fridge) (open ?a))", two)) << "grounding opens and closes";
  EXPECT_FALSE(fits("(count >= 3 (?a - Fridge) (open ?a))", two));
  EXPECT_TRUE(fits("(count = 1 (?a - Mug) (exists (?b - Shelf) (on ?a ?b)))", two)) << "grounding moves mugs";
  EXPECT_TRUE(fits("(exists (?b - Shelf) (and))", two)) << "what the home lacks altogether may be set up";
  EXPECT_FALSE(fits("(count = 2 (?r - Kitchen) (and))", two)) << "no room is built";
}

TEST(Misfit, IsAStartThatShutsTheAgentOutOfAllRooms) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  const std::vector<Formula> outside = {
      *parse_formula("test", "(forall (?r - Kitchen) (not (in_room agent ?r)))", FormulaUse::State)};
  EXPECT_EQ(misfit(outside, knowledge, offer_with({"Fridge"}).now), nullptr) << "the living room is left";
  Trace one_room;
  one_room.entities.push_back({Entity::Kind::Room, "kitchen_1", "Kitchen", ""});
  one_room.states.emplace_back();
  one_room.states.front().set_exists(EntityIndex(0));
  EXPECT_EQ(misfit(outside, knowledge, one_room), outside.data());
}

TEST(Misfit, IsTooLittleFurnitureForTwoConstraintsThatNoneMeetsTogether) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  const auto fits = [&](const std::vector<const char*>& starts, const std::vector<std::string>& home) {
    std::vector<Formula> init;
    for (const char* start : starts) init.push_back(*parse_formula("test", start, FormulaUse::State));
    return misfit(init, knowledge, offer_with(home).now) == nullptr;
  };
  const std::vector<const char*> one_is_open = {"(count = 1 (?a - Fridge) (open ?a))",
                                                "(count >= 1 (?a - Fridge) (not (open ?a)))"};
  EXPECT_FALSE(fits(one_is_open, {"Fridge", "Mug"}));
  EXPECT_TRUE(fits(one_is_open, {"Fridge", "Fridge"}));
  EXPECT_TRUE(fits(one_is_open, {"Mug"})) << "what the home lacks altogether may be set up";
  EXPECT_TRUE(fits({"(count = 1 (?a - Mug) (dirty ?a))", "(count >= 1 (?a - Mug) (not (dirty ?a)))"}, {"Mug"}));
  EXPECT_TRUE(fits({"(count = 1 (?a - Fridge) (open ?a))", "(exists (?a - Fridge) (and))"}, {"Fridge"}));
}

TEST(RefineReferring, BothAndTwoOfAreAboutAsManyAsTheStartHas) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  const auto all = made("wash-all", {{"A", "Mug"}, {"T", "Sink"}});
  bool both = false;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto refined = refine_referring(all, knowledge, small_offer(), "by-attribute", Rng(seed));
    ASSERT_TRUE(refined);
    const auto* quantifier = referring(refined->goal);
    EXPECT_EQ(quantifier->op, Formula::Op::Forall);
    for (const auto& start : refined->init) {
      both = both || (start.op == Formula::Op::Count && start.comparison == Comparison::Equal && start.number == 2);
    }
  }
  EXPECT_TRUE(both);
}

TEST(RefineReferring, NeverRefersByAStateThatTheGoalChanges) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  const auto plain = made("wash-one", {{"A", "Mug"}, {"T", "Sink"}});
  std::set<std::string> wheres;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const auto refined = refine_referring(plain, knowledge, {}, "", Rng(seed));
    ASSERT_TRUE(refined);
    wheres.insert(to_text(referring(refined->goal)->domain.where.front()));
  }
  EXPECT_FALSE(wheres.contains("(dirty ?a)"));
  EXPECT_FALSE(wheres.contains("(hot ?a)")) << "nobody sees it";
  EXPECT_GT(wheres.size(), 2U) << "states and places both occur";
}

TEST(RefineReferring, NeverNamesThePlaceThatTheGoalIsAbout) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  const auto plain = made("place-one-on", {{"A", "Book"}, {"B", "Table"}});
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const auto refined = refine_referring(plain, knowledge, small_offer(), "by-relation", Rng(seed));
    ASSERT_TRUE(refined);
    EXPECT_NE(referring(refined->goal)->domain.where.front().domain.members[0].category, "Table");
  }
}

TEST(RefineReferring, KeepsToStatesThatTheSimulatorShows) {
  for (const auto simulator : {Simulator::Virtualhome, Simulator::Habitat}) {
    const auto knowledge = small_home(simulator);
    const auto plain = made("place-one-on", {{"A", "Mug"}, {"B", "Table"}}, simulator);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      EXPECT_FALSE(refine_referring(plain, knowledge, small_offer(), "by-state", Rng(seed)));
    }
  }
}

TEST(RefineReferring, LeavesNumbersWithAnUpperLimitAlone) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  auto source = library_template("two-and-at-most-one-on");
  std::erase_if(source.constraints, [](const auto& one) { return one.type == ConstraintType::Kind; });
  const auto plain = instantiate(source, knowledge, *sample_binding(source, knowledge, {}, Rng(1)));
  ASSERT_TRUE(plain);
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const auto refined = refine_referring(*plain, knowledge, small_offer(), "", Rng(seed));
    if (!refined) continue;
    const auto* quantifier = referring(refined->goal);
    EXPECT_FALSE(quantifier->op == Formula::Op::Count && quantifier->comparison == Comparison::AtMost);
  }
}

TEST(RefineReferring, IsDeterministicAndDoesNotRefineTwice) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  const auto plain = made("place-one-on", {{"A", "Mug"}, {"B", "Table"}});
  const auto first = refine_referring(plain, knowledge, {}, "", Rng(5));
  const auto second = refine_referring(plain, knowledge, {}, "", Rng(5));
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->goal, second->goal);
  EXPECT_EQ(first->init, second->init);
  EXPECT_FALSE(refine_referring(*first, knowledge, {}, "", Rng(5)));
}

TEST(RefineLinguistic, FunctionAcceptsEveryCategoryThatServes) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  const auto plain = made("place-one-on", {{"A", "Mug"}, {"B", "Table"}});
  const auto refined = refine_linguistic(plain, knowledge, {}, "function", Rng(3));
  ASSERT_TRUE(refined);
  EXPECT_EQ(refined->split, Split::Linguistic);
  EXPECT_EQ(to_text(refined->goal), "(exists (?a - (either Bowl Mug)) (exists (?b - Table) (at-end (on ?a ?b))))");
  for (const auto& start : starts_by_rejection(*refined, knowledge, Rng(3), 500))
    ASSERT_FALSE(holds(refined->goal, start)) << "a Bowl on the Table would already do";
}

TEST(RefineLinguistic, AnAsideKeepsTheGoal) {
  const auto plain = made("place-one-on", {{"A", "Apple"}, {"B", "Table"}});
  const auto refined = refine_linguistic(plain, small_home(Simulator::Ai2thor), {}, "aside", Rng(1));
  ASSERT_TRUE(refined);
  EXPECT_EQ(name_of(refined->style), "aside");
  EXPECT_EQ(refined->goal, plain.goal);
}

/// "The one that is not dirty": the start has one that is meant, and others.
TEST(RefineLinguistic, WhatIsToldApartIsOneOfSeveral) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  const auto plain = made("place-one-on", {{"A", "Mug"}, {"B", "Table"}});
  for (const char* style : {"negation", "ellipsis", "anaphora"}) {
    const auto refined = refine_linguistic(plain, knowledge, {}, style, Rng(1));
    ASSERT_TRUE(refined) << style;
    EXPECT_EQ(name_of(refined->style), style);
    for (const auto& start : starts_by_rejection(*refined, knowledge, Rng(2), 500)) {
      EXPECT_EQ(members_of(refined->goal.domain, refined->goal.variable, start).size(), 1U) << style;
      EXPECT_GT(members_of(of_category("Mug"), "x", start).size(), 1U) << style;
    }
  }
}

/// A room or a piece of furniture has no other name.
TEST(StyleFit, LeavesOutWhatHasNoOtherName) {
  const auto has_alias = [](const char* name) {
    const auto styles = styles_fitting(library_template(name));
    return std::find(styles.begin(), styles.end(), Style::Alias) != styles.end();
  };
  EXPECT_TRUE(styles_fitting(library_template("go-to-room")).empty());
  EXPECT_TRUE(has_alias("place-one-on"));
  EXPECT_FALSE(has_alias("go-to-room"));
  EXPECT_FALSE(has_alias("close-all-in-room"));
}

/// "A few" is two or three at least, and neither exactly two nor at least four.
TEST(StyleFit, AFewIsSaidOfTwoOrThreeAtLeast) {
  const auto count_of = [](const auto& self, Formula& formula) -> Formula* {
    if (formula.op == Formula::Op::Count) return &formula;
    for (Formula& child : formula.children) {
      if (Formula* found = self(self, child)) return found;
    }
    return nullptr;
  };
  Template source = library_template("two-slices-on");
  Formula* count = count_of(count_of, source.goal);
  ASSERT_NE(count, nullptr);
  for (const auto& [comparison, number, fits] :
       {std::tuple(Comparison::AtLeast, 2, true), std::tuple(Comparison::AtLeast, 3, true),
        std::tuple(Comparison::AtLeast, 4, false), std::tuple(Comparison::Equal, 2, false),
        std::tuple(Comparison::AtMost, 3, false)}) {
    count->comparison = comparison;
    count->number = number;
    const auto styles = styles_fitting(source);
    EXPECT_EQ(std::find(styles.begin(), styles.end(), Style::VagueQuantity) != styles.end(), fits) << number;
  }
}

TEST(RefineLinguistic, DoesNotApplyWithoutWordsForIt) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  EXPECT_FALSE(
      refine_linguistic(made("place-one-on", {{"A", "Plate"}, {"B", "Table"}}), knowledge, {}, "alias", Rng(1)));
  EXPECT_FALSE(refine_linguistic(made("open-one", {{"A", "Fridge"}}), knowledge, {}, "function", Rng(1)));
}

}  // namespace
}  // namespace unietp
