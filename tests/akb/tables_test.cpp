// What the committed tables must be, whoever edits them.
#include "akb/tables.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "akb/fit.h"
#include "core/files.h"
#include "scene/simulator.h"
#include "tests/akb/small_tables.h"

namespace unietp {
namespace {

class CommittedTables : public ::testing::TestWithParam<Simulator> {
 protected:
  void SetUp() override {
    tables = test::committed(GetParam());
    for (const auto& c : tables.categories) by_name[c.name] = &c;
    for (const auto& f : tables.affordances) facts.emplace(f.category, f.affordance);
  }
  bool afforded(const std::string& name, const std::string& affordance) const {
    return facts.contains({name, affordance});
  }
  /// Furniture that a layout places.
  bool furniture(const std::string& name) const {
    return !by_name.at(name)->movable && !by_name.at(name)->rooms.empty();
  }

  Tables tables;
  std::map<std::string, const Category*> by_name;
  std::set<std::pair<std::string, std::string>> facts;  // category, affordance
};
INSTANTIATE_TEST_SUITE_P(Each, CommittedTables, ::testing::ValuesIn(kSimulators),
                         [](const auto& simulator) { return std::string(name_of(simulator.param)); });

TEST_P(CommittedTables, HaveAsManyCategoriesAsTheSimulator) {
  static const std::map<Simulator, std::size_t> kCount{
      {Simulator::Ai2thor, 125}, {Simulator::Virtualhome, 181}, {Simulator::Habitat, 389}, {Simulator::Behavior, 1829}};
  EXPECT_EQ(tables.categories.size(), kCount.at(GetParam()));
}

TEST_P(CommittedTables, AreWrittenInTheirOwnOrderAndForm) {
  auto sorted = tables;
  sort_tables(sorted);
  for (const auto& table : table_names()) {
    const auto text = read_file(test::committed_tables() / std::string(name_of(GetParam())) / (table + ".csv"));
    ASSERT_TRUE(text);
    EXPECT_EQ(table_csv(sorted, table), *text) << table;
  }
}

TEST_P(CommittedTables, NameNoSourceThatMayNotBeShipped) {
  const auto allowed = [](const Source& source) {
    for (const char* word : {"hssd", "replica", "watch_and_help", "wah_", "brunch", "procthor_houses", "derived_"}) {
      if (source.source.find(word) != std::string::npos) return false;
    }
    return well_formed_source(source.source) && source.confidence > 0 && source.confidence <= 1;
  };
  for (const auto& c : tables.categories) {
    const bool named = c.source.source == "metadata:hssd_semantic_lexicon.json";  // a name alone: no fact of HSSD's
    EXPECT_TRUE((named || allowed(c.source)) && allowed(c.size_source) && allowed(c.mass_source)) << c.name;
  }
  for (const auto& f : tables.affordances) EXPECT_TRUE(allowed(f.source)) << f.category << " " << f.affordance;
  for (const auto& p : tables.placements) EXPECT_TRUE(allowed(p.source)) << p.object << " " << p.receptacle;
  for (const auto& e : tables.effects) EXPECT_TRUE(allowed(e.source)) << e.tool << " " << e.target;
  for (const auto& a : tables.aliases) EXPECT_TRUE(allowed(a.source)) << a.category << " " << a.text;
}

TEST_P(CommittedTables, MovableIsExactlyWhatCanBePickedUp) {
  for (const auto& c : tables.categories) {
    EXPECT_EQ(c.movable, afforded(c.name, "pickupable")) << c.name;
    if (c.movable) {
      EXPECT_LE(c.mass, 15) << c.name;
      EXPECT_FALSE(c.rooms.empty()) << c.name;
      EXPECT_GE(c.size.minCoeff(), 0.003) << c.name;
      EXPECT_LE(c.size.maxCoeff(), 1.5) << c.name;
    }
  }
}

TEST_P(CommittedTables, OnlyBodiesWithAJointAreOpenable) {
  const std::set<Archetype> jointed{Archetype::Cabinet, Archetype::Drawers, Archetype::Lidded, Archetype::Folding};
  for (const auto& f : tables.affordances) {
    if (f.affordance == "openable") {
      EXPECT_TRUE(jointed.contains(by_name.at(f.category)->archetype)) << f.category;
    }
  }
}

TEST_P(CommittedTables, WhatGoesInsideIsSmallerThanWhatHoldsItAndFitsTheRoomThere) {
  for (const auto& p : tables.placements) {
    if (p.relation == Predicate::NextTo) continue;  // bodies_test looks for the support of both
    const Category &object = *by_name.at(p.object), &receptacle = *by_name.at(p.receptacle);
    const auto room = room_of(receptacle, p.relation);
    ASSERT_TRUE(room) << p.object << " " << info(p.relation).name << " " << p.receptacle;
    EXPECT_TRUE(fits(object.size, *room)) << p.object << " " << info(p.relation).name << " " << p.receptacle;
    EXPECT_LE(p.capacity, capacity_of(object, p.relation, receptacle)) << p.object << " " << p.receptacle;
    const auto small = std::minmax({object.size.x(), object.size.y()});
    const auto large = std::minmax({receptacle.size.x(), receptacle.size.y()});
    EXPECT_LT(small.first, large.first) << p.object << " " << p.receptacle;
    EXPECT_LT(small.second, large.second) << p.object << " " << p.receptacle;
    if (p.relation == Predicate::Inside) {
      EXPECT_TRUE(afforded(p.receptacle, "container") || afforded(p.receptacle, "openable") ||
                  afforded(p.receptacle, "receptacle"))
          << p.receptacle;
    }
    EXPECT_TRUE(object.movable || p.relation == Predicate::On) << p.object << " is furniture inside " << p.receptacle;
  }
}

// Places on dishes and in bags count: raw meat stands on one piece of furniture that makes sense, a counter, and a raw
// egg without its shell on none. Chests and what sweeps and unclogs stand on the floor, which no table of places has.
TEST_P(CommittedTables, EveryMovableHasThreePlaces) {
  const std::set<std::string> on_floors{"Plunger",     "ScrubBrush",    "broom", "carpet_sweeper",
                                        "cedar_chest", "magazine_rack", "vacuum"};
  const std::set<std::string> on_dishes{"EggCracked", "raw_egg"};
  for (const auto& c : tables.categories) {
    if (!c.movable || on_floors.contains(c.name)) continue;
    int places = 0, on_furniture = 0;
    for (const auto& p : tables.placements) {
      if (p.object != c.name || (p.relation != Predicate::On && p.relation != Predicate::Inside)) continue;
      ++places;
      on_furniture += furniture(p.receptacle) ? 1 : 0;
    }
    EXPECT_GE(places, on_dishes.contains(c.name) ? 2 : 3) << c.name;
    EXPECT_GE(on_furniture, on_dishes.contains(c.name) ? 0 : 1) << c.name;
  }
}

TEST_P(CommittedTables, EverySmallKitchenThingFitsSomethingThatOpens) {
  // BEHAVIOR opens no freezer, nightstand or stove, where these are kept.
  const std::set<std::string> kept_open{"bag_of_ice_cream", "half_duck", "ice", "lighter", "match", "match_box"};
  for (const auto& c : tables.categories) {
    if (kept_open.contains(c.name)) continue;
    if (!c.movable || c.rooms.front() != "kitchen" || c.size.maxCoeff() > 0.35 || c.name == "EggCracked") continue;
    const bool stored = std::any_of(tables.placements.begin(), tables.placements.end(), [&](const Placement& p) {
      return p.object == c.name && p.relation == Predicate::Inside && furniture(p.receptacle) &&
             afforded(p.receptacle, "openable");
    });
    EXPECT_TRUE(stored) << c.name;
  }
}

TEST_P(CommittedTables, EveryOpenableFurnitureHoldsSomething) {
  for (const auto& f : tables.affordances) {
    if (f.affordance != "openable" || by_name.at(f.category)->movable) continue;
    const auto held = std::count_if(tables.placements.begin(), tables.placements.end(), [&](const Placement& p) {
      return p.receptacle == f.category && p.relation == Predicate::Inside;
    });
    EXPECT_GE(held, 4) << f.category;
  }
}

TEST_P(CommittedTables, LikelihoodsOfAnObjectSumToOne) {
  std::map<std::string, double> sum;
  for (const auto& p : tables.placements) {
    const bool place = p.relation == Predicate::On || p.relation == Predicate::Inside;
    sum[p.object + (place ? "" : " " + std::string(info(p.relation).name))] += p.likelihood;
  }
  for (const auto& [object, total] : sum) EXPECT_NEAR(total, 1, 0.01) << object;
}

TEST_P(CommittedTables, SayWhatStandsBesideAndUnderWhat) {
  std::map<Predicate, int> count;
  for (const auto& p : tables.placements) {
    ++count[p.relation];
    EXPECT_NE(p.object, p.receptacle);
  }
  EXPECT_GE(count[Predicate::NextTo], 250);
  EXPECT_GE(count[Predicate::Under], 15);
}

TEST_P(CommittedTables, ModelsHaveBoxesOfCategories) {
  for (const auto& asset : tables.assets) {
    EXPECT_TRUE(by_name.contains(asset.category)) << asset.name;
    EXPECT_GT(asset.size.minCoeff(), 0) << asset.name;
    EXPECT_LE(asset.size.maxCoeff(), 20) << asset.name;
  }
}

TEST_P(CommittedTables, ToolsReachTheirTargetsAndSlicesAreSmaller) {
  for (const auto& e : tables.effects) {
    const Category &tool = *by_name.at(e.tool), &target = *by_name.at(e.target);
    for (const auto& [need, relation] :
         {std::pair(EffectNeed::Inside, Predicate::Inside), std::pair(EffectNeed::On, Predicate::On)}) {
      if (has_need(e, need)) {
        EXPECT_TRUE(fits(target, relation, tool)) << e.tool << " " << name_of(e.treatment) << " " << e.target;
      }
    }
    if (has_need(e, EffectNeed::PowerOn)) {
      EXPECT_TRUE(afforded(e.tool, "switchable") || e.tool == "StoveBurner") << e.tool;
    }
    if (has_need(e, EffectNeed::Held)) {
      EXPECT_TRUE(tool.movable) << e.tool;
    }
    if (e.treatment == Treatment::Slices) {
      const Category& piece = *by_name.at(e.gives);
      EXPECT_TRUE(piece.movable) << e.gives;
      EXPECT_LE(piece.mass, target.mass) << e.gives;
      EXPECT_TRUE(afforded(e.target, "sliceable")) << e.target;
    }
  }
  const bool has_effects = GetParam() == Simulator::Ai2thor || GetParam() == Simulator::Behavior;
  EXPECT_EQ(!tables.effects.empty(), has_effects);
}

TEST_P(CommittedTables, SynonymsNameOneCategoryOnly) {
  std::map<std::string, std::set<std::string>> named;
  for (const auto& c : tables.categories) named[c.display].insert(c.name);
  for (const auto& a : tables.aliases) {
    if (a.kind == AliasKind::Synonym) named[a.text].insert(a.category);
  }
  std::map<AliasKind, std::set<std::string>> categories;
  for (const auto& a : tables.aliases) {
    categories[a.kind].insert(a.category);
    if (a.kind == AliasKind::Synonym) {
      EXPECT_EQ(named[a.text].size(), 1U) << a.text;
    }
  }
  EXPECT_GE(categories[AliasKind::Synonym].size(), 65U);
  EXPECT_GE(categories[AliasKind::Context].size(), 30U);
}

TEST_P(CommittedTables, FurnishEveryRoomOfAHome) {
  for (const char* room : {"kitchen", "living_room", "bedroom", "bathroom", "dining_room", "corridor", "office"}) {
    const auto count = std::count_if(tables.categories.begin(), tables.categories.end(), [&](const Category& c) {
      return !c.movable && std::find(c.rooms.begin(), c.rooms.end(), room) != c.rooms.end();
    });
    EXPECT_GE(count, 3) << room;
  }
  EXPECT_GE(
      std::count_if(tables.categories.begin(), tables.categories.end(), [](const Category& c) { return c.movable; }),
      40);
}

TEST_P(CommittedTables, DisplayNamesAreUniqueEnglish) {
  std::set<std::string> seen;
  for (const auto& c : tables.categories) {
    EXPECT_TRUE(seen.insert(c.display).second) << c.display;
    EXPECT_EQ(c.display.find_first_of("_0123456789"), std::string::npos) << c.display;
    EXPECT_EQ(c.countable, c.plural != c.display) << c.display;
  }
}

}  // namespace
}  // namespace unietp
