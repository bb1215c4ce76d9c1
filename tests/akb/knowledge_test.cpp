#include "akb/knowledge.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "akb/table_words.h"
#include "core/rng.h"
#include "tests/akb/small_tables.h"

namespace unietp {
namespace {

Knowledge knowledge_of(Simulator simulator) {
  auto t = test::committed(simulator);
  return {simulator, t.categories, t.affordances, t.placements, t.effects, t.aliases, t.assets};
}

/// Rows that a linear scan finds, in table order: the oracle of the indices.
template <class Row, class Test>
std::vector<const Row*> scan(const std::vector<Row>& rows, const Test& test) {
  std::vector<const Row*> found;
  for (const auto& row : rows) {
    if (test(row)) found.push_back(&row);
  }
  return found;
}

class EachSimulator : public ::testing::TestWithParam<Simulator> {};
INSTANTIATE_TEST_SUITE_P(Knowledge, EachSimulator, ::testing::ValuesIn(kSimulators),
                         [](const auto& simulator) { return std::string(name_of(simulator.param)); });

TEST_P(EachSimulator, EveryQueryFindsWhatALinearScanFinds) {
  const Knowledge k = knowledge_of(GetParam());
  for (const auto& c : k.categories()) {
    const std::string& name = c.name;
    EXPECT_EQ(k.find(name), &c);
    for (const auto& affordance : affordance_names()) {
      const auto facts = scan(
          k.affordances(), [&](const AffordanceFact& f) { return f.category == name && f.affordance == affordance; });
      EXPECT_EQ(k.has(name, affordance), !facts.empty());
    }
    for (const Predicate relation : {Predicate::On, Predicate::Inside, Predicate::NextTo}) {
      EXPECT_EQ(k.placements_of(name, relation),
                scan(k.placements(), [&](const Placement& p) { return p.object == name && p.relation == relation; }));
      EXPECT_EQ(k.placements_at(name, relation), scan(k.placements(), [&](const Placement& p) {
                  return p.receptacle == name && p.relation == relation;
                }));
    }
    for (const Treatment treatment : {Treatment::Heats, Treatment::Washes, Treatment::Slices, Treatment::Fills}) {
      EXPECT_EQ(k.effects_of(name, treatment),
                scan(k.effects(), [&](const Effect& e) { return e.tool == name && e.treatment == treatment; }));
      EXPECT_EQ(k.effects_on(name, treatment),
                scan(k.effects(), [&](const Effect& e) { return e.target == name && e.treatment == treatment; }));
    }
    for (const AliasKind kind : kAliasKinds) {
      EXPECT_EQ(k.aliases_of(name, kind),
                scan(k.aliases(), [&](const Alias& a) { return a.category == name && a.kind == kind; }));
    }
  }
  for (const auto& p : k.placements()) EXPECT_EQ(k.placement(p.object, p.relation, p.receptacle), &p);
  for (const auto& e : k.effects()) {
    const auto* found = k.effect(e.tool, e.treatment, e.target);
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->target, e.target);
  }
  for (const auto& affordance : affordance_names()) {
    std::vector<std::string> expected;
    for (const auto& f : k.affordances()) {
      if (f.affordance == affordance) expected.push_back(f.category);
    }
    EXPECT_EQ(k.with_affordance(affordance), expected);
  }
}

TEST(Knowledge, ACopyAndAMoveAnswerLikeTheOriginal) {
  Knowledge original = knowledge_of(Simulator::Ai2thor);
  const Knowledge copy = original;
  const auto expected = original.with_affordance("openable");
  const Knowledge moved = std::move(original);
  EXPECT_EQ(copy.with_affordance("openable"), expected);
  EXPECT_EQ(moved.with_affordance("openable"), expected);
  const auto& asset = copy.assets().empty() ? nullptr : &copy.assets().front();
  if (asset != nullptr) {
    EXPECT_EQ(copy.asset(asset->name), asset);
  }
  EXPECT_EQ(copy.find("Mug"), &*std::find_if(copy.categories().begin(), copy.categories().end(),
                                             [](const Category& c) { return c.name == "Mug"; }));
}

TEST(Knowledge, WhatIsUnknownIsNotFound) {
  const Knowledge k = knowledge_of(Simulator::Habitat);
  EXPECT_EQ(k.find("unicorn"), nullptr);
  EXPECT_EQ(k.find(""), nullptr);
  EXPECT_FALSE(k.has("cup", "sliceable"));
  EXPECT_FALSE(k.has("cup", "flyable"));
  EXPECT_EQ(k.placement("couch", Predicate::Inside, "cup"), nullptr);
  EXPECT_TRUE(k.placements_of("unicorn", Predicate::On).empty());
  EXPECT_TRUE(k.effects_of("zzz", Treatment::Heats).empty());
  EXPECT_TRUE(k.aliases_of("unicorn", AliasKind::Synonym).empty());
  EXPECT_TRUE(k.affordances_of("unicorn").empty());
}

TEST(Knowledge, RowsThatNameNoCategoryAreFoundToo) {
  const Source curated{"curated", 1};
  const Knowledge k(
      Simulator::Ai2thor, {}, {{"cup", "shiny", curated}}, {{"cup", Predicate::NextTo, "shelf", 0.5, 1, curated}},
      {{"sink", Treatment::Washes, "cup", "", 0, {}, curated}}, {{"cup", "beaker", AliasKind::Synonym, curated}},
      {{"Cup_1", "cup", Vec3(1, 1, 1), curated}, {"Cup_2", "cup", Vec3(2, 2, 2), curated}});
  EXPECT_TRUE(k.has("cup", "shiny"));
  EXPECT_NE(k.placement("cup", Predicate::NextTo, "shelf"), nullptr);
  EXPECT_EQ(k.placements_at("shelf", Predicate::NextTo).size(), 1U);
  EXPECT_NE(k.effect("sink", Treatment::Washes, "cup"), nullptr);
  EXPECT_EQ(k.aliases_of("cup", AliasKind::Synonym).size(), 1U);
  EXPECT_EQ(k.asset_rows_of("cup").size(), 2U);
  EXPECT_EQ(k.asset("Cup_2")->size.x(), 2);
  EXPECT_EQ(k.asset("Cup_3"), nullptr);
  EXPECT_EQ(k.find("cup"), nullptr);
}

TEST(Knowledge, OrderOfTheInputDoesNotMatterForAnySeed) {
  const auto tables = test::committed(Simulator::Virtualhome);
  const Knowledge sorted = knowledge_of(Simulator::Virtualhome);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    auto shuffled = tables;
    rng.shuffle(shuffled.categories);
    rng.shuffle(shuffled.placements);
    rng.shuffle(shuffled.affordances);
    const Knowledge k(Simulator::Virtualhome, shuffled.categories, shuffled.affordances, shuffled.placements,
                      shuffled.effects, shuffled.aliases);
    EXPECT_EQ(k.with_affordance("pickupable"), sorted.with_affordance("pickupable"));
    const auto here = k.placements_of("mug", Predicate::On), there = sorted.placements_of("mug", Predicate::On);
    ASSERT_EQ(here.size(), there.size());
    for (std::size_t i = 0; i < here.size(); ++i) EXPECT_EQ(here[i]->receptacle, there[i]->receptacle);
  }
}

}  // namespace
}  // namespace unietp
