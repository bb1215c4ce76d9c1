#include "akb/facts.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "tests/akb/small_tables.h"

namespace unietp {
namespace {

std::vector<std::string> said_of(const Knowledge& knowledge, const std::string& category) {
  std::vector<std::string> lines;
  for (const auto& fact : facts_of(knowledge, *knowledge.find(category)))
    lines.push_back(fact.name + " = " + fact.value + " [" + fact.source.source + "]");
  return lines;
}

TEST(Facts, SayEverythingThatTheTablesSayOfACategory) {
  const auto knowledge = test::small_knowledge();
  EXPECT_EQ(
      said_of(knowledge, "apple"),
      (std::vector<std::string>{
          "display = apple [curated]", "plural = apples [curated]", "synset = apple.n.01 [curated]",
          "countable = true [curated]", "movable = true [curated]", "archetype = sphere [curated]",
          "size = 0.08 x 0.08 x 0.08 [curated]", "mass = 0.2 [curated]", "rooms = kitchen [curated]",
          "colours = red|green [curated]", "pickupable = true [curated]", "sliceable = true [metadata:types.json]",
          "on:plate = 0.4 [llm:some-model]", "on:plate:capacity = 3 [llm:some-model]",
          "inside:fridge = 0.6 [derived:kind]", "inside:fridge:capacity = 12 [derived:kind]"}));
  const auto knife = said_of(knowledge, "knife");
  EXPECT_EQ(knife[knife.size() - 2], "slices:apple = 2 half_apple [curated]");
  EXPECT_EQ(knife.back(), "slices:apple:needs = held [curated]");
  const auto mug = said_of(knowledge, "mug");
  EXPECT_EQ(mug[mug.size() - 4], "alias:cup, with a handle = synonym [curated]");
  EXPECT_EQ(mug.back(), "asset:Mug_2 = 0.12 x 0.1 x 0.11 [metadata:assets.json]");
}

TEST(Facts, OfTheCommittedTablesHaveOneNameEachThatReadsBack) {
  for (const auto simulator : kSimulators) {
    SCOPED_TRACE(name_of(simulator));
    auto t = test::committed(simulator);
    const Knowledge knowledge = test::knowledge_of(simulator, t);
    std::size_t rows = 0;
    for (const auto& category : knowledge.categories()) {
      std::set<std::string> names;
      for (const auto& fact : facts_of(knowledge, category)) {
        EXPECT_TRUE(names.insert(fact.name).second) << category.name << " " << fact.name;
        const auto parsed = parse_fact(fact.name);
        ASSERT_TRUE(parsed) << fact.name << ": " << format(parsed.error());
        EXPECT_EQ(to_text(*parsed), fact.name);
        EXPECT_FALSE(fact.value.empty()) << category.name << " " << fact.name;
        rows += parsed->kind == FactName::Kind::Placement && parsed->detail.empty() ? 1 : 0;
        rows += parsed->kind == FactName::Kind::Affordance ? 1 : 0;
      }
    }
    EXPECT_EQ(rows, t.placements.size() + t.affordances.size());
  }
}

TEST(FactName, KnowsWhatStandsAfterTheColon) {
  EXPECT_EQ(*parse_fact("on:CounterTop:capacity"),
            (FactName{FactName::Kind::Placement, "on", "CounterTop", "capacity"}));
  EXPECT_EQ(*parse_fact("heats:Potato:needs"), (FactName{FactName::Kind::Effect, "heats", "Potato", "needs"}));
  EXPECT_EQ(*parse_fact("alias:odd: but true:needs"),
            (FactName{FactName::Kind::Alias, "alias", "odd: but true:needs", ""}));
  EXPECT_EQ(*parse_fact("openable"), (FactName{FactName::Kind::Affordance, "openable", "", ""}));
}

TEST(FactName, AnUnknownOneIsToldWithTheNearest) {
  const auto message = [](std::string_view text) { return parse_fact(text).error().message; };
  EXPECT_EQ(message("openble").substr(0, 51), "unknown fact 'openble'; did you mean 'openable'?; a");
  EXPECT_EQ(message("insde:Fridge").substr(0, 54), "unknown fact 'insde:Fridge'; did you mean 'inside'?; a");
  EXPECT_EQ(message("on:"), "nothing after the colon of 'on:'; expected a name, as in on:Mug");
  EXPECT_FALSE(parse_fact(""));
  EXPECT_FALSE(parse_fact(":"));
}

}  // namespace
}  // namespace unietp
