#include <cmath>
#include <iostream>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/text.h"
#include "import_rates.h"
#include "interchange/formats.h"
#include "interchange/scene_models.h"
#include "small_home.h"
#include "tests/support/needs.h"

namespace unietp::testing {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Json = nlohmann::json;

const std::string kInstance = R"({
  "stage_instance": {"template_name": "stages/home"},
  "object_instances": [
    {"template_name": "objects/frl_apartment_bowl_01", "motion_type": "DYNAMIC", "translation": [1, 0.8, -2],
     "rotation": [0.70711, 0, 0.70711, 0], "lights": 3},
    {"template_name": "objects/frl_apartment_sofa", "translation": [3, 0.4, -2]},
    {"template_name": "1efdc3d37dfab1eb9f99117bb84c59003d684811", "translation": [2, 0, -3],
     "translation_origin": "asset_local", "non_uniform_scale": [1, 2, 1]}],
  "articulated_object_instances": [
    {"template_name": "kitchenCupboard_01", "translation": [0, 1.5, -4], "rotation": [-0.707, 0.707, 0, 0],
     "initial_joint_pose": [0.3, 0]}]})";

SourceScene instance(const SceneModels& models = {}) {
  const auto scenes = read_habitat("home.scene_instance.json", kInstance, committed_knowledge(Simulator::Habitat),
                                   format_facts(), models);
  EXPECT_TRUE(scenes) << format(scenes.error());
  EXPECT_EQ(scenes->size(), 1U);
  return scenes->front();
}

TEST(Habitat, RealScenesArrive) {
  struct File {
    const char *name, *row;
    std::size_t stride;
  };
  for (const auto& [name, row, stride] :
       {File{"replicacad_scenes.json.gz", "replicacad", 9}, File{"hssd_scene_102344193_boxes.json", "hssd boxes", 1}}) {
    const auto text = read_maybe_gzip(upstream() / "habitat" / name);
    if (!text) GTEST_SKIP() << needs::kSimulatorFiles;
    const auto scenes = read_habitat(name, *text, committed_knowledge(Simulator::Habitat), format_facts());
    ASSERT_TRUE(scenes) << format(scenes.error());
    EXPECT_EQ(scenes->size(), std::string_view(row) == "replicacad" ? 90U : 1U);
    const auto all = import_all(*scenes, std::getenv("UNIETP_WHOLE_IMPORT") ? 1 : stride);
    for (const auto& [scene, report, restless] : all) {
      SCOPED_TRACE(scene);
      EXPECT_GT(report.known, 10);
      EXPECT_GE(arrived_share(report), 0.95);
      EXPECT_EQ(report.relations, 0) << "these files state none";
    }
    std::cout << table_row(row, all) << "\n";
  }
}

TEST(Habitat, ASceneOfHashesIsKnownOnlyThroughATableOfModels) {
  const char* name = "hssd_scene_102343992.scene_instance.json.gz";
  const auto text = read_maybe_gzip(upstream() / "habitat" / name);
  if (!text) GTEST_SKIP() << needs::kSimulatorFiles;
  const auto bare = read_habitat(name, *text, committed_knowledge(Simulator::Habitat), format_facts());
  ASSERT_TRUE(bare) << format(bare.error());
  ASSERT_EQ(bare->front().objects.size(), 357U);
  SceneModels models;
  for (const SourceObject& object : bare->front().objects) {
    EXPECT_EQ(object.category, "");
    models[object.id.substr(0, object.id.rfind('_'))] = {"chair", Vec3(0.5, 0.5, 0.9), 4};
  }
  const auto known = read_habitat(name, *text, committed_knowledge(Simulator::Habitat), format_facts(), models);
  ASSERT_TRUE(known) << format(known.error());
  for (const SourceObject& object : known->front().objects) {
    EXPECT_EQ(object.category, "chair");
    EXPECT_EQ(object.mass, 4);
  }
  const auto all = import_all(*known, 1);
  EXPECT_GE(arrived_share(all.front().report), 0.95);
  std::cout << table_row("hssd instance", all) << "\n";
}

TEST(Habitat, PosesTurnFromYUpToZUp) {
  const SourceScene scene = instance();
  const SourceObject& bowl = scene.objects[0];
  EXPECT_EQ(bowl.category, "bowl");
  EXPECT_EQ(bowl.pose.position, Vec3(1, 2, 0.8));
  // A quarter turn about y takes the front from -z to -x.
  EXPECT_LT((bowl.pose.rotation * -Vec3::UnitY() - -Vec3::UnitX()).norm(), 1e-4);
  EXPECT_LT((bowl.pose.rotation * Vec3::UnitZ() - Vec3::UnitZ()).norm(), 1e-9);
}

TEST(Habitat, FurnitureOnTheFloorIsTwiceAsTallAsItsMiddleIsHigh) {
  const SourceScene scene = instance();
  EXPECT_EQ(scene.objects[1].category, "couch");
  EXPECT_NEAR(scene.objects[1].size.z(), 0.8, 1e-9);
  EXPECT_EQ(scene.objects[1].size.x(), committed_knowledge(Simulator::Habitat).find("couch")->size.x());
  EXPECT_THAT(scene.warnings, Contains(HasSubstr("typical size")));
}

TEST(Habitat, RobotDescriptionsThatAreZUpInThemselvesStandUpright) {
  const SourceObject cupboard = instance().objects[3];
  EXPECT_EQ(cupboard.category, "cabinet");
  EXPECT_GT((cupboard.pose.rotation * Vec3::UnitZ()).z(), 0.99);
  EXPECT_NEAR(cupboard.opening, 0.3 / (std::numbers::pi / 2), 1e-9);
}

TEST(Habitat, ATableOfModelsGivesCategoriesSizesAndMasses) {
  const auto models = read_scene_models("assets.json", R"({"templates": {
    "1efdc3d37dfab1eb9f99117bb84c59003d684811": {"category": "chair", "size": [0.5, 0.6, 0.9], "mass": 7},
    "objects/frl_apartment_bowl_01.object_config.json": {"mass": 0.2, "COM": [0, 0, 0]}}})");
  ASSERT_TRUE(models) << format(models.error());
  const SourceScene scene = instance(*models);
  const SourceObject& chair = scene.objects[2];
  EXPECT_EQ(chair.category, "chair");
  EXPECT_EQ(chair.size, Vec3(0.5, 0.6, 1.8)) << "twice as tall by its scale";
  EXPECT_EQ(chair.mass, 7);
  EXPECT_NEAR(chair.pose.position.z(), 0.9, 1e-9) << "its translation is that of its foot";
  EXPECT_EQ(scene.objects[0].mass, 0.2);
  EXPECT_EQ(instance().objects[2].category, "") << "a hash says nothing";
}

TEST(Habitat, HssdsOwnTablesGiveTheCategoriesOfHashes) {
  const auto models = read_scene_models("objects.csv.gz",
                                        "id,name,clean_category,main_category\n"
                                        "1efdc3d37dfab1eb9f99117bb84c59003d684811,\"Chair, oak\",chair,seating\n");
  ASSERT_TRUE(models) << format(models.error());
  EXPECT_EQ(instance(*models).objects[2].category, "chair");
  const auto main = read_scene_models("fpmodels.csv", "main_category,id\nbed,f00\n");
  ASSERT_TRUE(main) << format(main.error());
  EXPECT_EQ(main->at("f00").category, "bed");
  const auto without = read_scene_models("fpmodels.csv", "id,name\nf00,Bed\n");
  ASSERT_FALSE(without);
  EXPECT_EQ(format(without.error()),
            "fpmodels.csv:1:1: schema error: expected the columns id and clean_category or main_category");
}

TEST(Habitat, TemplatesSpeakOfCategories) {
  for (const auto& [name, category] :
       std::vector<std::pair<std::string, std::string>>{{"objects/frl_apartment_indoor_plant_02", "potted_plant"},
                                                        {"frl_apartment_tvstand", "tv_stand"},
                                                        {"002_master_chef_can", "can"},
                                                        {"chestOfDrawers_01", "chest_of_drawers"},
                                                        {"frl_apartment_setupbox", "setupbox"},
                                                        {"door2", "door"}}) {
    EXPECT_EQ(habitat_category(name, committed_knowledge(Simulator::Habitat), format_facts()), category) << name;
  }
}

TEST(Habitat, WhatGoesOutComesInTheSameForAnySeed) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const Scene home = small_home(committed_knowledge(Simulator::Habitat), seed);
    const auto exported = write_habitat(home, committed_knowledge(Simulator::Habitat));
    ASSERT_TRUE(exported) << format(exported.error());
    const auto scenes = read_habitat("small_home.scene_instance.json", exported->text,
                                     committed_knowledge(Simulator::Habitat), format_facts());
    ASSERT_TRUE(scenes) << format(scenes.error());
    EXPECT_EQ(scenes->front().id, home.id);
    const auto again = assemble(scenes->front(), committed_knowledge(Simulator::Habitat),
                                profile_of(Simulator::Habitat), format_facts(), {.settle = false});
    ASSERT_TRUE(again) << format(again.error());
    EXPECT_THAT(differences(home, again->scene, 1e-6), IsEmpty());
  }
}

TEST(Habitat, ExportsInstancesAsHabitatReadsThem) {
  Scene home = small_home(committed_knowledge(Simulator::Habitat), 3);
  home.nodes = {home.nodes.front()};
  home.nodes.edit(0).pose = upright(Vec3(1, 2, 0.5), std::numbers::pi);
  home.nodes.edit(0).openable = false;
  const auto exported = write_habitat(home, committed_knowledge(Simulator::Habitat));
  ASSERT_TRUE(exported) << format(exported.error());
  const Json json = Json::parse(exported->text);
  EXPECT_TRUE(json.contains("stage_instance"));
  EXPECT_THAT(json["articulated_object_instances"], IsEmpty());
  const Json& object = json["object_instances"].at(0);
  EXPECT_EQ(object["translation"], Json({1.0, 0.5, -2.0}));
  EXPECT_EQ(object["translation_origin"], "COM");
  EXPECT_NEAR(std::abs(object["rotation"][0].get<double>()), 1, 1e-9) << "fronts along -z are not turned";
  EXPECT_TRUE(json["user_defined"]["templates"].contains(object["template_name"].get<std::string>()));
}

TEST(Habitat, BadScenesGetAnErrorWithItsPlace) {
  const auto with = [](const std::string& from, const std::string& to) {
    const auto scenes = read_habitat("home.json", replace_all(kInstance, from, to),
                                     committed_knowledge(Simulator::Habitat), format_facts());
    return scenes ? std::string("accepted") : format(scenes.error());
  };
  EXPECT_EQ(with("[3, 0.4, -2]", "[3, 0.4]"),
            "home.json#/object_instances/1/translation: schema error: expected [x, y, z], not 2 items");
  EXPECT_THAT(with("[3, 0.4, -2]", "[3, NaN, -2]"), HasSubstr("home.json:6:72: parse error"));
  EXPECT_EQ(with("[-0.707, 0.707, 0, 0]", "[-1.707, 0.707, 0, 0]"),
            "home.json#/articulated_object_instances/0/rotation: schema error: expected a quaternion of length 1, not "
            "1.8476195495826515");
  EXPECT_EQ(with("[1, 2, 1]", "[1, 0, 1]"),
            "home.json#/object_instances/2: schema error: expected a scale that is not zero");
  EXPECT_EQ(with("\"objects/frl_apartment_sofa\"", "7"),
            "home.json#/object_instances/1/template_name: schema error: expected a string, not a JSON number");
  EXPECT_EQ(with(kInstance, "[]"), "accepted") << "a list of no homes";
  EXPECT_EQ(with(kInstance, "{\"a\": 3}"),
            "home.json#/a: schema error: expected a home, an object with the field object_instances or "
            "articulated_object_instances or stage_instance or objects");
  EXPECT_THAT(with(kInstance, kInstance.substr(0, 300)), HasSubstr("parse error"));
}

}  // namespace
}  // namespace unietp::testing
