// The questions that people ask of the knowledge bases, put to the real program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/text.h"
#include "program.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using Json = nlohmann::json;

const fs::path kTables = fs::path(UNIETP_SOURCE_DIR) / "data" / "akb";
const std::string kHeader = "simulator,category,fact,value,reason\n";

Ended ask(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "knowledge");
  return run_program(arguments);
}
Json json_of(const Ended& ended) {
  auto json = Json::parse(ended.out, nullptr, false);
  EXPECT_FALSE(json.is_discarded()) << ended.out << ended.err;
  return json;
}

TEST(Why, AFactThatHoldsTellsItsSourceItsLicenseAndWhereToChangeIt) {
  const auto ended = ask({"why", "ai2thor", "Fridge", "openable"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("ai2thor Fridge openable: true\n"));
  EXPECT_THAT(ended.out, HasSubstr("metadata:object_types.json, confidence "));
  EXPECT_THAT(ended.out, HasSubstr("MIT"));
  EXPECT_THAT(ended.out, HasSubstr("override.csv"));
  EXPECT_THAT(ended.out, HasSubstr("ai2thor,Fridge,openable,VALUE,REASON"));
}

TEST(Why, ADerivedFactExplainsItsRule) {
  const auto shown = json_of(ask({"show", "habitat", "bowl", "--json"}));
  for (const auto& fact : shown["facts"]) {
    if (fact["source"] != "derived:kind") continue;
    const auto json = json_of(ask({"why", "habitat", "bowl", fact["fact"], "--json"}));
    EXPECT_EQ(json["holds"], true);
    EXPECT_EQ(json["value"], fact["value"]);
    EXPECT_THAT(json["rule"].get<std::string>(), HasSubstr("kept there"));
    return;
  }
  ADD_FAILURE() << "no place of a bowl is derived by kind";
}

TEST(Why, AFactThatDoesNotHoldTellsWhatToWriteAndEndsWithOne) {
  const auto ended = ask({"why", "ai2thor", "Fridge", "pickupable"});
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.out, HasSubstr("does not hold"));
  EXPECT_THAT(ended.out, HasSubstr("ai2thor,Fridge,pickupable,true,REASON"));
}

TEST(Why, UnknownNamesAreToldWithTheNearestOne) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"why", "ai2thorr", "Mug", "size"}, "did you mean \"ai2thor\""},
      {{"why", "ai2thor", "Mugg", "size"}, "did you mean \"Mug\""},
      {{"why", "ai2thor", "Mug", "sice"}, "did you mean 'size'"},
      {{"why", "ai2thor", "Mug", "on:CounterTob"}, "did you mean \"CounterTop\""}};
  for (const auto& [arguments, message] : cases) {
    const auto ended = ask(arguments);
    EXPECT_EQ(ended.code, 2) << message;
    EXPECT_THAT(ended.err, HasSubstr(message));
  }
}

TEST(Overrides, OfOnesOwnWinAndAreNamedAsTheSource) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_file(folder.at("mine.csv"), kHeader + "ai2thor,Mug,mass,0.77,\"weighed, twice\"\n"
                                                          "ai2thor,Fridge,openable,false,taped shut\n"));
  const auto mass = json_of(ask({"why", "ai2thor", "Mug", "mass", "--json", "--overrides", folder.at("mine.csv")}));
  EXPECT_EQ(mass["value"], "0.77");
  EXPECT_EQ(mass["source"], "override:mine.csv");
  EXPECT_EQ(mass["overrides"][0]["line"], 2);
  EXPECT_EQ(mass["overrides"][0]["reason"], "weighed, twice");
  const auto shut = ask({"why", "ai2thor", "Fridge", "openable", "--overrides", folder.at("mine.csv")});
  EXPECT_EQ(shut.code, 1);
  EXPECT_THAT(shut.out, HasSubstr("mine.csv:3 says false: taped shut"));
  EXPECT_EQ(ask({"why", "ai2thor", "Fridge", "openable"}).code, 0);  // without it nothing has changed
}

TEST(Overrides, ThatAreWrongStopEveryCommandWithTheirPlaces) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_file(folder.at("mine.csv"), kHeader + "ai2thor,Mugg,mass,1,r\nai2thor,Mug,mass,heavy,r\n"));
  const auto ended =
      run_program({"generate", "--count", "4", "--out", folder.at("out"), "--overrides", folder.at("mine.csv")});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("mine.csv:2:9: schema error: ai2thor has no category 'Mugg'; did you mean 'Mug'?"));
  EXPECT_THAT(ended.err, HasSubstr("mine.csv:3:18: schema error: bad value 'heavy' of mass"));
  EXPECT_FALSE(fs::exists(folder.at("out")));
}

TEST(Diff, OfAFolderAndItsCompilationIsEmpty) {
  const auto database = std::string(trim(ask({"build"}).out));
  const auto ended = ask({"diff", kTables.string(), database});
  EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_EQ(ended.out, "0 added, 0 removed, 0 changed\n");
}

TEST(Diff, TellsEachFactThatChanged) {
  const ScratchFolder folder;
  fs::copy(kTables, folder.path() / "t", fs::copy_options::recursive);
  fs::copy(kTables.parent_path() / "sense", folder.path() / "sense");  // phrases are laid over the tables from there
  const auto committed = read_file(kTables / "override.csv");
  ASSERT_TRUE(committed);
  ASSERT_TRUE(write_file(folder.at("t/override.csv"), *committed + "ai2thor,Mug,mass,0.77,weighed\n"
                                                                   "ai2thor,Fridge,openable,false,taped shut\n"
                                                                   "habitat,bowl,alias:test dish,true,a word\n"
                                                                   "behavior,apple,mass,0.31,weighed\n"));
  const auto ended = ask({"diff", kTables.string(), folder.at("t")});
  EXPECT_EQ(ended.code, 1) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("- ai2thor Fridge openable true ["));
  EXPECT_THAT(ended.out, HasSubstr("~ ai2thor Mug mass "));
  EXPECT_THAT(ended.out, HasSubstr(" -> 0.77 ["));
  EXPECT_THAT(ended.out, HasSubstr("+ habitat bowl alias:test dish synonym [override:override.csv, confidence 1]"));
  EXPECT_THAT(ended.out, HasSubstr("1 added, 1 removed, 2 changed\n"));
  EXPECT_THAT(ended.out, HasSubstr("~ behavior apple mass "));
  const auto json = json_of(ask({"diff", kTables.string(), folder.at("t"), "--json"}));
  EXPECT_EQ(json["facts"].size(), 4U);
  EXPECT_EQ(json["facts"][2]["old"], nullptr);
  EXPECT_EQ(ask({"diff", kTables.string(), folder.at("nowhere")}).code, 2);
}

TEST(Stats, TellCoverageByAffordanceAndSourceAndWhatIsMissing) {
  const auto text = ask({"stats", "ai2thor"});
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("ai2thor: 125 categories"));
  EXPECT_THAT(text.out, HasSubstr("pickupable"));
  EXPECT_THAT(text.out, HasSubstr("metadata:object_types.json"));
  EXPECT_THAT(text.out, HasSubstr("categories without synset"));
  const auto json = json_of(ask({"stats", "ai2thor", "--json"}));
  ASSERT_EQ(json.size(), 1U);
  EXPECT_EQ(json[0]["categories"], 125);
  const auto missing = ask({"stats", "ai2thor", "--missing"});
  const auto& named = json[0]["missing"]["synset"];
  EXPECT_THAT(missing.out, HasSubstr("ai2thor " + named[0].get<std::string>() + " has no synset\n"));
  EXPECT_THAT(ask({"stats"}).out, HasSubstr("behavior"));
}

TEST(Show, AsJsonListsTheFactsOfACategory) {
  const auto json = json_of(ask({"show", "ai2thor", "Mug", "--json"}));
  EXPECT_EQ(json["category"], "Mug");
  EXPECT_EQ(json["facts"][0]["fact"], "display");
  EXPECT_THAT(ask({"show", "ai2thor", "Mugg"}).err, HasSubstr("did you mean \"Mug\""));
  EXPECT_GE(json_of(ask({"show", "ai2thor", "--json"}))["categories"].size(), 125U);
}

}  // namespace
}  // namespace unietp
