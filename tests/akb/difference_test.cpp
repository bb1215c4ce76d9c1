#include "akb/difference.h"

#include <functional>

#include <gtest/gtest.h>

#include "tests/akb/small_tables.h"

namespace unietp {
namespace {

Tables tables_of(const Knowledge& k) {
  return {k.categories(), k.affordances(), k.placements(), k.effects(), k.aliases(), k.assets()};
}
Knowledge changed(const std::function<void(Tables&)>& change) {
  auto tables = tables_of(test::small_knowledge());
  change(tables);
  return test::knowledge_of(Simulator::Ai2thor, std::move(tables));
}
std::vector<std::string> lines(const std::vector<Difference>& differences) {
  std::vector<std::string> texts;
  for (const auto& d : differences)
    texts.push_back(d.category + " " + d.name + ": " + (d.old ? d.old->value : "-") + " -> " +
                    (d.now ? d.now->value : "-") + (d.same_value() ? " (source)" : ""));
  return texts;
}
using Lines = std::vector<std::string>;

TEST(Differences, OfAKnowledgeBaseAndItselfAreNone) {
  EXPECT_TRUE(differences(test::small_knowledge(), test::small_knowledge()).empty());
  for (const auto simulator : kSimulators) {
    const auto knowledge = test::knowledge_of(simulator, test::committed(simulator));
    EXPECT_TRUE(differences(knowledge, knowledge).empty());
  }
}

TEST(Differences, AreWhatIsAddedRemovedAndChangedInOrder) {
  const auto now = changed([](Tables& t) {
    t.affordances.push_back({"knife", "pickupable", {"curated", 1}});
    std::erase_if(t.affordances, [](const AffordanceFact& f) { return f.affordance == "openable"; });
    t.categories.front().mass = 0.25;
    t.placements.front().capacity = 4;
    t.placements.back().source.confidence = 0.9;
  });
  const Lines expected{
      "apple inside:fridge:capacity: 12 -> 4",    "apple mass: 0.2 -> 0.25",    "apple on:plate: 0.4 -> 0.4 (source)",
      "apple on:plate:capacity: 3 -> 3 (source)", "fridge openable: true -> -", "knife pickupable: - -> true"};
  EXPECT_EQ(lines(differences(test::small_knowledge(), now)), expected);
}

TEST(Differences, TurnAroundWithTheirSides) {
  const auto old = test::small_knowledge();
  const auto now = changed([](Tables& t) {
    t.aliases.push_back({"plate", "dish", AliasKind::Synonym, {"curated", 1}});
    t.effects.clear();
  });
  auto back = differences(now, old);
  for (auto& d : back) std::swap(d.old, d.now);
  EXPECT_EQ(back, differences(old, now));
  EXPECT_FALSE(back.empty());
}

TEST(Differences, ACategoryThatOnlyOneSideHasDiffersInEveryFact) {
  const auto without = changed([](Tables& t) {
    std::erase_if(t.categories, [](const Category& c) { return c.name == "knife"; });
    std::erase_if(t.effects, [](const Effect& e) { return e.tool == "knife"; });
  });
  const auto all = test::small_knowledge();
  EXPECT_EQ(differences(without, all).size(), facts_of(all, *all.find("knife")).size());
}

}  // namespace
}  // namespace unietp
