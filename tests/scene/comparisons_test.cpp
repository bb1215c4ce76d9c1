#include "scene/comparisons.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "random_scene.h"
#include "scene/size_and_nearness.h"

namespace unietp {
namespace {

Compared compared_by(std::string_view text, FormulaUse use) {
  const auto formula = parse_formula("test", text, use);
  EXPECT_TRUE(formula) << text;
  Compared compared;
  if (formula) compared.add(*formula);
  return compared;
}

TEST(Compared, AreTheCategoriesOfTheVariablesThatAComparisonNamesAndNoOthers) {
  const auto nearest = compared_by(
      "(at-end (exists (?x - Mug) (exists (?y - (Fridge :where (nearest ?y ?x))) (exists (?z - Table) (on ?x ?z)))))",
      FormulaUse::Goal);
  EXPECT_EQ(nearest.categories, (std::vector<std::string>{"Fridge", "Mug"}));
  EXPECT_FALSE(nearest.all);
  const auto size = compared_by("(exists (?x - (either Mug Bread/slice)) (size ?x large))", FormulaUse::State);
  EXPECT_EQ(size.categories, (std::vector<std::string>{"Bread", "Mug"}));
  EXPECT_TRUE(compared_by("(exists (?x - object) (exists (?y - Mug) (nearest ?x ?y)))", FormulaUse::State).all);
  EXPECT_TRUE(compared_by("(exists (?x - Mug) (exists (?y - Table) (on ?x ?y)))", FormulaUse::State).none());
}

TEST(Compared, AreReadAsInAReadingThatComparesEverythingAndNothingElseIsForAnySeed) {
  int related = 0, sized = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    Scene scene = random_scene(rng);
    const std::vector<std::string> categories{"Bread", "Fridge", "Mug", "Plate"};
    for (int i = 0; i < 12; ++i) {
      Node node = random_node("compared_" + std::to_string(i), rng);
      node.category = categories[rng.below(categories.size())];
      scene.nodes.push_back(std::move(node));
    }
    Compared compared;
    compared.categories = {"Fridge", "Mug"};
    const Trace some = read_state(scene, compared), every = to_logic(scene, {}, true);
    ASSERT_EQ(some.entities, every.entities);
    const auto of_named = [&](EntityIndex e) {
      const Entity& entity = every.entities[e];
      return std::binary_search(compared.categories.begin(), compared.categories.end(), entity.category) ||
             std::binary_search(compared.categories.begin(), compared.categories.end(), entity.slice_of);
    };
    const Facts &few = some.states.front(), &all = every.states.front();
    for (EntityIndex x; x.index() < every.entities.size(); ++x) {
      for (const char* size : {"large", "small"}) {
        if (!of_named(x)) continue;
        EXPECT_EQ(few.holds(Predicate::Size, x, size), all.holds(Predicate::Size, x, size)) << every.entities[x].id;
        sized += few.holds(Predicate::Size, x, size) ? 1 : 0;
      }
      for (EntityIndex y; y.index() < every.entities.size(); ++y) {
        for (const PredicateInfo& one : all_predicates()) {
          if (one.predicate == Predicate::Nearest) continue;
          EXPECT_EQ(few.holds(one.predicate, x, y), all.holds(one.predicate, x, y));
        }
        if (of_named(x) && of_named(y)) {
          EXPECT_EQ(few.holds(Predicate::Nearest, x, y), all.holds(Predicate::Nearest, x, y));
          related += few.holds(Predicate::Nearest, x, y) ? 1 : 0;
        } else if (every.entities[x].category == "Plate" || every.entities[y].category == "Plate") {
          EXPECT_FALSE(few.holds(Predicate::Nearest, x, y));
        }
      }
    }
  }
  EXPECT_GT(related, 100);
  EXPECT_GT(sized, 20);
}

/// The size of each of two mugs of which one has so many times the volume of the other.
std::vector<std::string> sizes_at_ratio(double ratio) {
  SharedList<Node> nodes;
  for (const double volume : {1.0, ratio}) {
    Node mug;
    mug.category = "Mug";
    mug.size = {0.1, 0.1, 0.1 * volume};
    nodes.push_back(std::move(mug));
  }
  std::vector<std::string> said(2);
  for (const auto& [place, size] : sizes_of(nodes, {0, 1})) said[place] += size;
  return said;
}

TEST(Sizes, AThingIsSmallOrLargeOnlyByAClearMargin) {
  const std::vector<std::string> none{"", ""}, first_small{"small", "large"}, first_large{"large", "small"};
  EXPECT_EQ(sizes_at_ratio(1), none);
  EXPECT_EQ(sizes_at_ratio(1.28), none);
  EXPECT_EQ(sizes_at_ratio(1.32), first_small);
  EXPECT_EQ(sizes_at_ratio(1 / 1.28), none);
  EXPECT_EQ(sizes_at_ratio(1 / 1.32), first_large);
}

TEST(Sizes, TheMarginIsToTheNextOneAmongMany) {
  SharedList<Node> nodes;
  for (const double height : {0.1, 0.12, 0.2, 0.4}) {
    Node mug;
    mug.category = "Mug";
    mug.size = {0.1, 0.1, height};
    nodes.push_back(std::move(mug));
  }
  using Sizes = std::vector<std::pair<std::size_t, std::string>>;
  EXPECT_EQ(sizes_of(nodes, {0, 1, 2, 3}), (Sizes{{3, "large"}}));  // the least is close to the next
  EXPECT_EQ(sizes_of(nodes, {1, 2, 3}), (Sizes{{3, "large"}, {1, "small"}}));
  EXPECT_EQ(sizes_of(nodes, {2}), Sizes{});
}

}  // namespace
}  // namespace unietp
