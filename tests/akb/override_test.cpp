// What a person knows better wins over everything.
#include "akb/override.h"

#include <algorithm>
#include <ostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "akb/csv.h"
#include "core/files.h"
#include "tests/akb/small_tables.h"

namespace unietp {
namespace {

const std::string kHeader = "simulator,category,fact,value,reason\n";

/// The small tables of all simulators with an override file over them.
struct Laid {
  std::vector<Tables> tables;
  std::vector<Error> errors;
};
Laid lay(const std::string& rows, const std::string& later_rows = "") {
  const ScratchFolder folder;
  test::write_small_tables(folder.path() / "t", test::small_tables());
  EXPECT_TRUE(write_file(folder.path() / "mine.csv", kHeader + rows));
  Laid laid;
  EXPECT_TRUE(write_file(folder.path() / "later.csv", kHeader + later_rows));
  laid.tables =
      read_all_tables(folder.path() / "t", {folder.path() / "mine.csv", folder.path() / "later.csv"}, laid.errors);
  return laid;
}

/// What habitat's tables say of a fact after an override, "" when it does not hold.
std::string said(const Laid& laid, const std::string& category, const std::string& name) {
  const auto knowledge = test::knowledge_of(Simulator::Habitat, laid.tables.at(2));
  for (const auto& fact : facts_of(knowledge, *knowledge.find(category))) {
    if (fact.name == name) return fact.value + " [" + fact.source.source + "]";
  }
  return "";
}

struct Case {
  const char *name, *category, *fact, *value, *expected;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }
class EveryFact : public ::testing::TestWithParam<Case> {};

TEST_P(EveryFact, SaysAfterwardsWhatTheOverrideSays) {
  const auto& [name, category, fact, value, expected] = GetParam();
  const auto laid = lay(csv_line({"habitat", category, fact, value, "I measured it"}));
  ASSERT_TRUE(laid.errors.empty()) << format(laid.errors.front());
  EXPECT_EQ(said(laid, category, fact), expected);
  // The other simulators keep theirs.
  const auto untouched = lay("");
  for (const auto& table : table_names())
    EXPECT_EQ(table_csv(laid.tables.at(0), table), table_csv(untouched.tables.at(0), table));
}

INSTANTIATE_TEST_SUITE_P(
    Override, EveryFact,
    ::testing::Values(Case{"Display", "mug", "display", "coffee mug", "coffee mug [override:mine.csv]"},
                      Case{"Plural", "mug", "plural", "coffee mugs", "coffee mugs [override:mine.csv]"},
                      Case{"Synset", "fridge", "synset", "electric_refrigerator.n.01",
                           "electric_refrigerator.n.01 [override:mine.csv]"},
                      Case{"NoSynset", "mug", "synset", "", ""},
                      Case{"Countable", "mug", "countable", "false", "false [override:mine.csv]"},
                      Case{"Archetype", "mug", "archetype", "cylinder", "cylinder [override:mine.csv]"},
                      Case{"Size", "mug", "size", "0.2 x 0.15x0.3", "0.2 x 0.15 x 0.3 [override:mine.csv]"},
                      Case{"Mass", "mug", "mass", "0.45", "0.45 [override:mine.csv]"},
                      Case{"Rooms", "mug", "rooms", "office|bedroom", "office|bedroom [override:mine.csv]"},
                      Case{"NoColours", "mug", "colours", "", ""},
                      Case{"Movable", "fridge", "movable", "true", "true [override:mine.csv]"},
                      Case{"NewAffordance", "mug", "fillable", "true", "true [override:mine.csv]"},
                      Case{"KnownAffordance", "fridge", "openable", "true", "true [override:mine.csv]"},
                      Case{"NoAffordance", "fridge", "openable", "false", ""},
                      Case{"NewPlace", "mug", "on:plate", "true", "1 [override:mine.csv]"},
                      Case{"NewPlaceLikeOthers", "apple", "next_to:mug", "true", "0.5 [override:mine.csv]"},
                      Case{"LikelyPlace", "apple", "inside:fridge", "0.9", "0.9 [override:mine.csv]"},
                      Case{"KnownPlace", "apple", "inside:fridge", "true", "0.6 [override:mine.csv]"},
                      Case{"NoPlace", "apple", "inside:fridge", "false", ""},
                      Case{"Capacity", "apple", "inside:fridge:capacity", "20", "20 [override:mine.csv]"},
                      Case{"NewEffect", "fridge", "cools:mug", "true", "true [override:mine.csv]"},
                      Case{"NoEffect", "fridge", "cools:apple", "false", ""},
                      Case{"Pieces", "knife", "slices:apple", "4 half_apple", "4 half_apple [override:mine.csv]"},
                      Case{"Dispensed", "fridge", "dispenses:mug", "water", "water [override:mine.csv]"},
                      Case{"Needs", "fridge", "cools:apple:needs", "closed", "closed [override:mine.csv]"},
                      Case{"NewAlias", "mug", "alias:beaker", "true", "synonym [override:mine.csv]"},
                      Case{"AliasOfAKind", "mug", "alias:a thing with a handle", "function",
                           "function [override:mine.csv]"},
                      Case{"NoAlias", "mug", "alias:cup, with a handle", "false", ""},
                      Case{"Asset", "mug", "asset:Mug_3", "0.1 x 0.1 x 0.1", "0.1 x 0.1 x 0.1 [override:mine.csv]"},
                      Case{"NoAsset", "mug", "asset:Mug_1", "false", ""}),
    [](const auto& c) { return std::string(c.param.name); });

TEST(Override, WhatCanBePickedUpIsMovable) {
  const auto laid = lay("habitat,mug,pickupable,false,glued to its table\n");
  EXPECT_EQ(said(laid, "mug", "pickupable"), "");
  EXPECT_EQ(said(laid, "mug", "movable"), "false [override:mine.csv]");
  const auto back = lay("habitat,fridge,movable,true,a toy\n");
  EXPECT_EQ(said(back, "fridge", "pickupable"), "true [override:mine.csv]");
}

TEST(Override, ANewEffectNeedsWhatTheToolsOthersNeed) {
  const auto laid = lay("habitat,fridge,cools:mug,true,drinks\n");
  EXPECT_EQ(said(laid, "fridge", "cools:mug:needs"), "closed|inside [override:mine.csv]");
}

TEST(Override, AnEffectKeepsItsOwnNeedsWhenItsResultChanges) {
  const std::string own = "habitat,fridge,cools:mug,true,drinks\nhabitat,fridge,cools:mug:needs,power_on,tried\n";
  const auto laid = lay(own, "habitat,fridge,cools:mug,plate,a trick\n");
  ASSERT_TRUE(laid.errors.empty()) << format(laid.errors.front());
  EXPECT_EQ(said(laid, "fridge", "cools:mug"), "plate [override:later.csv]");
  EXPECT_EQ(said(laid, "fridge", "cools:mug:needs"), "power_on [override:later.csv]");  // an effect has one source
  EXPECT_EQ(said(laid, "fridge", "cools:apple:needs"), "closed|inside [curated]");
}

TEST(Override, RowsCountOneAfterTheOther) {
  const auto laid = lay("habitat,mug,on:plate,0.2,seen\nhabitat,mug,on:plate:capacity,2,counted\n");
  ASSERT_TRUE(laid.errors.empty()) << format(laid.errors.front());
  EXPECT_EQ(said(laid, "mug", "on:plate:capacity"), "2 [override:mine.csv]");
}

struct Fault {
  const char *name, *row, *expected;
};
void PrintTo(const Fault& f, std::ostream* out) { *out << f.name; }
class BadOverride : public ::testing::TestWithParam<Fault> {};

TEST_P(BadOverride, IsPlacedAndToldWhatIsAccepted) {
  const auto laid = lay(GetParam().row + std::string("\n"));
  ASSERT_EQ(laid.errors.size(), 1U);
  EXPECT_THAT(format(laid.errors.front()), ::testing::HasSubstr(GetParam().expected));
}

INSTANTIATE_TEST_SUITE_P(
    Each, BadOverride,
    ::testing::Values(
        Fault{
            "Simulator", "habitatt,mug,mass,1,r",
            "mine.csv:2:1: schema error: unknown simulator 'habitatt'; expected one of ai2thor, virtualhome, habitat, "
            "behavior; did you mean 'habitat'?"},
        Fault{"Category", "habitat,mugg,mass,1,r",
              "mine.csv:2:9: schema error: habitat has no category 'mugg'; did you mean 'mug'?"},
        Fault{"Fact", "habitat,mug,mas,1,r", "mine.csv:2:13: schema error: unknown fact 'mas'; did you mean 'mass'?"},
        Fault{"Receptacle", "habitat,mug,on:plat,true,r",
              "mine.csv:2:13: schema error: habitat has no category 'plat'; did you mean 'plate'?"},
        Fault{"Reason", "habitat,mug,mass,1,", "mine.csv:2:20: schema error: empty reason; expected a text"},
        Fault{"Mass", "habitat,mug,mass,heavy,r",
              "mine.csv:2:18: schema error: bad value 'heavy' of mass; expected kilograms > 0 and <= 90000"},
        Fault{"MassOfNothing", "habitat,mug,mass,nan,r", "bad value 'nan' of mass"},
        Fault{"Size", "habitat,mug,size,0.1 x 0.2,r",
              "mine.csv:2:18: schema error: bad value '0.1 x 0.2' of size; expected width, depth and height in meters"},
        Fault{"SizeOfNothing", "habitat,mug,size,0 x 1 x 1,r", "bad value '0 x 1 x 1' of size"},
        Fault{"Flag", "habitat,fridge,openable,yes,r",
              "mine.csv:2:25: schema error: bad value 'yes' of openable; expected true or false"},
        Fault{"Room", "habitat,mug,rooms,kichen,r", "bad value 'kichen' of rooms; expected nothing or, joined by |"},
        Fault{"Archetype", "habitat,mug,archetype,cup,r", "bad value 'cup' of archetype; expected one of "},
        Fault{"Likelihood", "habitat,apple,on:plate,1.5,r", "expected true, false or a likelihood > 0 and <= 1"},
        Fault{
            "CapacityOfNothing", "habitat,mug,on:plate:capacity,2,r",
            "mine.csv:2:13: schema error: 'on:plate' does not hold, so it has no capacity; expected a row before this "
            "one that makes it true"},
        Fault{"NeedsOfNothing", "habitat,mug,heats:apple:needs,held,r",
              "'heats:apple' does not hold, so it has no needs"},
        Fault{"Pieces", "habitat,knife,slices:mug,true,r", "expected a number of slices and their category"},
        Fault{"UnknownPieces", "habitat,knife,slices:apple,2 halves,r", "mine.csv:2:28: schema error: habitat has no"},
        Fault{"Alias", "habitat,mug,alias:cup,nickname,r", "expected true (a synonym), false or one of synonym"},
        Fault{"Twice", "habitat,mug,mass,1,r\nhabitat,mug,mass,2,r",
              "mine.csv:3:13: schema error: row for 'habitat mug mass' twice; expected one"}),
    [](const auto& f) { return std::string(f.param.name); });

TEST(Override, AllFaultsAreToldAtOnce) {
  const auto laid =
      lay("habitat,mug,mass,heavy,r\nai2thor,fridg,openable,true,r\nbehavior,mug,mas,1,\nhabitat,knife,slices:appl,"
          "true,r\n");
  EXPECT_EQ(laid.errors.size(), 5U);
}

class Compiled : public ::testing::Test {
 protected:
  void SetUp() override { test::write_small_tables(tables(), test::small_tables()); }
  std::filesystem::path tables() const { return folder_.path() / "t"; }
  std::filesystem::path write(const std::string& name, const std::string& rows) {
    EXPECT_TRUE(write_file(folder_.path() / name, kHeader + rows));
    return folder_.path() / name;
  }
  double mass_of_mug(const std::vector<std::filesystem::path>& overrides) {
    const auto errors = compile_knowledge(tables(), folder_.path() / "k.sqlite", overrides);
    EXPECT_TRUE(errors.empty()) << format(errors.front());
    const auto knowledge = load_knowledge(folder_.path() / "k.sqlite", Simulator::Habitat);
    return knowledge ? knowledge->find("mug")->mass : 0;
  }
  ScratchFolder folder_;
};

TEST_F(Compiled, TheLastFileWinsOverTheOneOfTheTablesAndThatOverTheTables) {
  EXPECT_EQ(mass_of_mug({}), 0.3);
  write("t/override.csv", "habitat,mug,mass,0.5,ours\n");
  EXPECT_EQ(mass_of_mug({}), 0.5);
  const auto mine = write("mine.csv", "habitat,mug,mass,0.6,mine\n");
  EXPECT_EQ(mass_of_mug({mine}), 0.6);
  EXPECT_EQ(mass_of_mug({mine, write("more.csv", "habitat,mug,mass,0.7,more\n")}), 0.7);
}

TEST_F(Compiled, TheDigestKnowsEveryByteOfAnOverrideAndItsNameButNotItsFolder) {
  const auto digest = [&](const std::vector<std::filesystem::path>& files) {
    return *digest_of_tables(tables(), files);
  };
  const auto none = digest({});
  const auto mine = write("mine.csv", "habitat,mug,mass,0.6,mine\n");
  const auto with_mine = digest({mine});
  EXPECT_NE(with_mine, none);
  EXPECT_NE(digest({write("other.csv", "habitat,mug,mass,0.6,mine\n")}), with_mine);
  EXPECT_EQ(digest({write("folder/mine.csv", "habitat,mug,mass,0.6,mine\n")}), with_mine);
  EXPECT_NE(digest({write("mine.csv", "habitat,mug,mass,0.61,mine\n")}), with_mine);
  write("t/override.csv", "");
  EXPECT_NE(digest({}), none);
}

TEST_F(Compiled, AMissingFileAndAFaultyTableAreErrorsAndLeaveNothing) {
  EXPECT_EQ(compile_knowledge(tables(), folder_.path() / "k.sqlite", {folder_.path() / "none.csv"}).size(), 1U);
  const auto mine = write("mine.csv", "habitat,mug,mass,heavy,r\n");
  EXPECT_EQ(compile_knowledge(tables(), folder_.path() / "k.sqlite", {mine}).size(), 1U);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "k.sqlite"));
}

TEST(Override, OfTheProjectItselfIsSound) {
  std::vector<Error> errors;
  read_all_tables(test::committed_tables(), {}, errors);
  EXPECT_TRUE(errors.empty()) << format(errors.front());
}

TEST(Override, BlanksInAFilesNameAreNoneInASource) {
  EXPECT_EQ(override_source("/a b/my own.csv"), "override:my_own.csv");
  EXPECT_TRUE(well_formed_source(override_source("my own.csv")));
}

}  // namespace
}  // namespace unietp
