// Tasks in the simulators' own scenes: made from their files, with their ids, and all of them expressed in their forms.
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/text.h"
#include "data_set.h"
#include "program.h"
#include "schema_checker.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

const fs::path kScenes = fs::path(UNIETP_SOURCE_DIR) / "tests" / "end_to_end" / "homes";

struct NativeSample {
  std::string simulator, file;
  std::string form;              // that expresses the tasks
  std::vector<std::string> ids;  // of some of the file's objects and rooms
};
std::string name_of_native_sample(const ::testing::TestParamInfo<NativeSample>& info) { return info.param.simulator; }

Ended make_native(const std::string& scenes, const std::string& out, int count) {
  return run_program({"generate", "--native", "--scenes", scenes, "--count", std::to_string(count), "--seed", "3",
                      "--splits", "atomic", "--out", out});
}

/// Ids of all objects and rooms in the homes of a data set.
std::set<std::string> ids_in(const fs::path& dataset) {
  std::set<std::string> ids;
  for (const auto& file : fs::directory_iterator(dataset / "homes")) {
    const auto text = read_maybe_gzip(file.path());
    EXPECT_TRUE(text);
    const Json home = Json::parse(*text);
    for (const char* list : {"nodes", "rooms"}) {
      for (const auto& one : home[list]) ids.insert(one["id"].get<std::string>());
    }
  }
  return ids;
}

class Native : public ::testing::TestWithParam<NativeSample> {};

TEST_P(Native, TasksAreInTheSimulatorsOwnSceneAndItsFormExpressesThem) {
  const auto& sample = GetParam();
  const ScratchFolder folder;
  const auto made = make_native((kScenes / sample.file).string(), folder.at("tasks"), 2);
  ASSERT_EQ(made.code, 0) << made.out << made.err;
  const auto verdict = validate(folder.at("tasks"));
  EXPECT_EQ(verdict.code, 0);
  EXPECT_EQ(verdict.proven, 2);
  const auto ids = ids_in(folder.at("tasks"));
  for (const auto& id : sample.ids) EXPECT_TRUE(ids.contains(id)) << id;
  ASSERT_EQ(run_program({"export", folder.at("tasks"), "--format", sample.form, "--out", folder.at("out")}).code, 0);
  EXPECT_EQ(read_file(folder.at("out") + "/left_out.jsonl").value(), "");
}

/// Exports tasks that are made in a scene of a simulator.
fs::path exported(const NativeSample& sample, const ScratchFolder& folder) {
  EXPECT_EQ(make_native((kScenes / sample.file).string(), folder.at("tasks"), 3).code, 0);
  EXPECT_EQ(run_program({"export", folder.at("tasks"), "--format", sample.form, "--out", folder.at("out")}).code, 0);
  EXPECT_EQ(read_file(folder.at("out") + "/left_out.jsonl").value(), "");
  return folder.at("out");
}

TEST(Native, AFloorPlanIsNamedAndAllOfItKeepsItsIds) {
  const ScratchFolder folder;
  const fs::path out = exported({"ai2thor", "kitchen.ithor.json", "ai2thor", {}}, folder);
  const Json plan = Json::parse(read_file(kScenes / "kitchen.ithor.json").value());
  std::set<std::string> ids;
  for (const auto& object : plan["objects"]) ids.insert(object["objectId"].get<std::string>());
  for (const auto& line : json_lines(fs::path(folder.at("tasks")) / "tasks.jsonl")) {
    const auto task = line["id"].get<std::string>();
    const Json house = Json::parse(read_file(out / (task + ".house.json")).value());
    EXPECT_EQ(house["scene"], "FloorPlan9");
    EXPECT_EQ(house["rooms"].size(), 1U);
    EXPECT_FALSE(house.contains("objects"));
    const Json json = Json::parse(read_file(out / (task + ".json")).value());
    for (const auto& [ours, theirs] : json["objects"].items()) {
      EXPECT_TRUE(ids.contains(theirs.get<std::string>()) ||
                  theirs.get<std::string>().find("Sliced_") != std::string::npos);
    }
    EXPECT_EQ(SchemaChecker().check(json, "ai2thor.schema.json"), "") << task;
    EXPECT_EQ(json["start"][0]["call"]["action"], "SetObjectPoses");
    EXPECT_EQ(json["start"][0]["call"]["objectPoses"].size(), 5U) << "what can move";
  }
}

TEST(Native, HabitatsOwnObjectsAreNamedByTheirTemplates) {
  const ScratchFolder folder;
  const fs::path out = exported({"habitat", "apartment.replicacad.scene_instance.json", "habitat", {}}, folder);
  const auto text = read_maybe_gzip(out / "episodes.json.gz");
  ASSERT_TRUE(text);
  int own = 0;
  const Json habitat = Json::parse(*text);
  for (const auto& episode : habitat["episodes"]) {
    for (const auto& object : episode["rigid_objs"]) {
      const auto name = object[0].get<std::string>();
      const bool is_own = name.starts_with("frl_apartment_");
      own += is_own ? 1 : 0;
      EXPECT_EQ(fs::exists(out / "objects" / name), !is_own) << "a stand-in only for what is not Habitat's: " << name;
    }
    for (const auto& [ours, handle] : episode["info"]["unietp"]["names"].items()) {
      if (ours.starts_with("frl_apartment_")) {
        EXPECT_EQ(handle, ours);
      }
    }
  }
  EXPECT_GT(own, 0);
  const Json config = Json::parse(read_file(out / "unietp.scene_dataset_config.json").value());
  EXPECT_THAT(config["objects"]["paths"][".json"].dump(), HasSubstr("replica_cad"));
}

TEST(Native, ModelsThatAreNamedByHashesNeedTheirTable) {
  const ScratchFolder folder;
  const std::string scene = (kScenes / "flat.hssd.scene_instance.json").string();
  const std::string models = (kScenes / "hssd_models.json").string();
  const auto without = make_native(scene, folder.at("none"), 2);
  EXPECT_EQ(without.code, 2);
  EXPECT_THAT(without.err, HasSubstr("needs a table of their categories (--assets)"));
  const auto with = run_program({"generate", "--native", "--scenes", scene, "--assets", models, "--count", "2",
                                 "--seed", "3", "--splits", "atomic", "--out", folder.at("tasks")});
  ASSERT_EQ(with.code, 0) << with.out << with.err;
  const Json table = Json::parse(read_file(models).value());
  int own = 0;
  for (const std::string& id : ids_in(folder.at("tasks"))) {
    const auto end = id.rfind("_:");
    own += end != std::string::npos && table.contains(id.substr(0, end)) ? 1 : 0;
  }
  EXPECT_GT(own, 0) << "objects have Habitat's handles";
  ASSERT_EQ(run_program({"export", folder.at("tasks"), "--format", "habitat", "--out", folder.at("out")}).code, 0);
  EXPECT_EQ(read_file(folder.at("out") + "/left_out.jsonl").value(), "");
  const auto alone = run_program({"generate", "--assets", models, "--count", "1", "--out", folder.at("alone")});
  EXPECT_EQ(alone.code, 2);
  EXPECT_THAT(alone.err, HasSubstr("is for --native"));
}

INSTANTIATE_TEST_SUITE_P(
    EachSimulator, Native,
    ::testing::Values(
        NativeSample{
            "ai2thor", "houses.procthor.jsonl", "ai2thor", {"Fridge|2|2", "Chair|2|3", "kitchen|2", "bedroom|3"}},
        NativeSample{
            "virtualhome", "flat.virtualhome.json", "virtualhome", {"mug.20", "plate.21", "kitchen.1", "bedroom.2"}},
        NativeSample{"habitat", "apartment.replicacad.scene_instance.json", "habitat", {"frl_apartment_sofa_:0000"}},
        NativeSample{"behavior", "small.behavior.json", "behavior", {"bowl_ajzltc_0"}}),
    name_of_native_sample);

TEST(Native, WhatIsNoSceneOfASimulatorIsRefused) {
  const ScratchFolder folder;
  const auto without = run_program({"generate", "--native", "--count", "1", "--out", folder.at("out")});
  EXPECT_EQ(without.code, 2);
  EXPECT_THAT(without.err, HasSubstr("needs --scenes"));
  ASSERT_EQ(run_program({"scene", "make", "--simulator", "habitat", "--count", "1", "--out", folder.at("homes")}).code,
            0);
  const auto ours = make_native(folder.at("homes"), folder.at("out"), 1);
  EXPECT_EQ(ours.code, 2);
  EXPECT_THAT(ours.err, HasSubstr("is no scene of a simulator"));
  EXPECT_FALSE(fs::exists(folder.at("out")));
}

}  // namespace
}  // namespace unietp
