#include "record/manifest_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;
using Json = nlohmann::ordered_json;

Json sound() {
  return Json::parse(
      R"({"format":"unietp-manifest/1","program":{"name":"unietp","version":"0.1.0"},"knowledge_digest":"digest","seed":7,
    "configuration":{"format":"unietp-run/1","seed":7,"count":3,"simulators":["habitat"],"splits":[],
      "quotas":{"splits":{"atomic":3},"simulators":{"habitat":3}},"templates":[],"without":["wave"],
      "modes":["M1","M3"],"phrasings":"training", "english": "us","sense":"tolerable","attempts":40,"block":256,"homes":"drawn","rooms":5,"objects":9},
    "counts":{"tasks":3,"candidates":5,"by_split":{"atomic":3},"by_simulator":{"habitat":3},
      "by_template":[{"template":"open-one","tasks":3}],
      "by_sense":{"tolerable":1,"usual":2},"by_form":{"habitat":2},"not_usual":[{"template":"open-one","tasks":1}],
      "balance":[{"dimension":"template","values":1,"effective":1,"variation":0}],
      "rejections":{"expert":{"no-plan":2}}},
    "files":[{"path":"a.txt","bytes":5,"sha256":"abc"}],"sources":[]})");
}

TEST(ReadManifest, TakesASoundOne) {
  const auto manifest = read_manifest("manifest.json", sound().dump());
  ASSERT_TRUE(manifest) << format(manifest.error());
  EXPECT_EQ(manifest->run.seed, 7U);
  EXPECT_THAT(manifest->run.by_split, ElementsAre(Pair("atomic", 3)));
  EXPECT_THAT(manifest->run.modes, ElementsAre(Mode::M1, Mode::M3));
  EXPECT_THAT(manifest->run.without, ElementsAre("wave"));
  EXPECT_EQ(manifest->phrasings, "training");
  EXPECT_EQ(manifest->run.sense, "tolerable");
  EXPECT_THAT(manifest->by_sense, ElementsAre(Pair("tolerable", 1), Pair("usual", 2)));
  EXPECT_THAT(manifest->by_form, ElementsAre(Pair("habitat", 2)));
  EXPECT_THAT(manifest->not_usual, ElementsAre(Pair("open-one", 1)));
  EXPECT_THAT(manifest->rejections, ElementsAre(Pair("expert", ElementsAre(Pair("no-plan", 2)))));
  EXPECT_EQ(manifest->files.at("a.txt").bytes, 5);
}

TEST(ReadManifest, RefusesMissingAndUnknownFieldsAndAnotherSeedThanTheConfigurations) {
  for (const auto* pointer : {"/configuration/modes", "/configuration/sense", "/counts/by_template", "/counts/by_sense",
                              "/counts/by_form", "/counts/not_usual", "/files", "/knowledge_digest"}) {
    Json json = sound();
    const Json::json_pointer place(pointer);
    json[place.parent_pointer()].erase(place.back());
    EXPECT_FALSE(read_manifest("manifest.json", json.dump())) << pointer;
  }
  Json json = sound();
  json["configuration"]["surprise"] = 1;
  EXPECT_FALSE(read_manifest("manifest.json", json.dump()));
  json = sound();
  json["seed"] = 8;
  const auto other = read_manifest("manifest.json", json.dump());
  ASSERT_FALSE(other);
  EXPECT_THAT(other.error().message, HasSubstr("seed"));
  json = sound();
  json["counts"]["tasks"] = 1e300;
  EXPECT_FALSE(read_manifest("manifest.json", json.dump()));
}

TEST(ReadManifest, TextsThatWereWrittenAnewHaveTheirOwnPhrasings) {
  Json json = sound();
  json["instructions"] = {{"writer", "llm"}, {"counts", Json::array()}};
  EXPECT_FALSE(read_manifest("manifest.json", json.dump()));
  json["instructions"]["phrasings"] = "all";
  EXPECT_FALSE(read_manifest("manifest.json", json.dump()));
  json["instructions"]["english"] = "gb";
  const auto manifest = read_manifest("manifest.json", json.dump());
  ASSERT_TRUE(manifest);
  EXPECT_EQ(manifest->phrasings, "all");
  EXPECT_EQ(manifest->english, "gb");
}

}  // namespace
}  // namespace unietp
