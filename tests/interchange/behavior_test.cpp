#include <algorithm>
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

SceneModels models() {
  return {{"armchair-abcdef", {"armchair", Vec3(0.8, 0.6, 0.9), 9}},
          {"floors-aaaaaa", {"floors", Vec3(3, 4, 0.2), 0}},
          {"floors-bbbbbb", {"floors", Vec3(3, 4, 0.2), 0}}};
}

/// Two rooms side by side, an armchair on the floor and one on a stage of 0.5 m, of another category's name.
const std::string kFlat = R"({"scene": "two_rooms", "objects": [
  {"name": "floors_1", "category": "floors", "model": "aaaaaa", "scale": [1, 1, 1], "fixed_base": true,
   "in_rooms": ["kitchen_0"], "pos": [2, 1.5, -0.1], "ori_xyzw": [0, 0, 0, 1], "joints": {}},
  {"name": "floors_2", "category": "floors", "model": "bbbbbb", "scale": [1, 1, 1], "fixed_base": true,
   "in_rooms": ["living_room_0"], "pos": [6.1, 1.5, -0.1], "ori_xyzw": [0, 0, 0, 1], "joints": {}},
  {"name": "chair_1", "category": "armchair", "model": "abcdef", "scale": [1, 1, 1], "fixed_base": false,
   "in_rooms": ["kitchen_0"], "pos": [1, 1, 0.55], "ori_xyzw": [0, 0, 0, 1], "joints": {"j": [0.3]}},
  {"name": "chair_2", "category": "old_chair", "model": "abcdef", "scale": [1, 1, 1], "fixed_base": false,
   "in_rooms": ["living_room_0"], "pos": [6, 1, 1.05], "ori_xyzw": [0, 0, 0.70711, 0.70711], "joints": {}}]})";

/// One chair as OmniGibson writes it.
std::string omnigibson(bool nested) {
  const std::string registry = R"({"object_registry": {"chair_1": {
    "root_link": {"pos": [1, 1, 0.55], "ori": [0, 0, 0, 1], "lin_vel": [0, 0, 0], "ang_vel": [0, 0, 0]},
    "joints": {"j": {"pos": [0.3], "vel": [0]}}, "non_kin": {"ToggledOn": {"value": true}}},
    "robot0": {"root_link": {"pos": [2, 2, 0], "ori": [0, 0, 0.70711, 0.70711]}, "joint_pos": [0, 0]}}})";
  return R"({"metadata": {}, "state": )" +
         (nested ? "{\"pos\": [0, 0, 0], \"registry\": " + registry + "}" : registry) +
         R"(, "objects_info": {"init_info": {
    "chair_1": {"class_module": "omnigibson.objects.dataset_object", "class_name": "DatasetObject",
      "args": {"name": "chair_1", "category": "armchair", "model": "abcdef", "scale": null, "fixed_base": false,
        "bounding_box": [0.7, 0.9, 1.0], "in_rooms": "kitchen_0"}},
    "gone": {"class_module": "omnigibson.objects.dataset_object", "args": {"category": "armchair", "model": "abcdef"}},
    "robot0": {"class_module": "omnigibson.robots.fetch", "class_name": "Fetch", "args": {"name": "robot0"}}}}})";
}

SourceScene read(const std::string& text) {
  const auto scenes = read_behavior("scene.json", text, committed_knowledge(Simulator::Behavior), models());
  EXPECT_TRUE(scenes) << format(scenes.error());
  return scenes->front();
}

TEST(Behavior, TheRealSceneArrives) {
  const auto text = read_maybe_gzip(upstream() / "behavior/scene_restaurant_brunch.json.gz");
  const auto inventory = read_maybe_gzip(upstream() / "behavior/object_inventory.json.gz");
  if (!text || !inventory) GTEST_SKIP() << needs::kSimulatorFiles;
  const auto table = read_behavior_inventory("object_inventory.json.gz", *inventory);
  ASSERT_TRUE(table) << format(table.error());
  for (const SceneModels& known : {SceneModels(), *table}) {
    const auto scenes =
        read_behavior("scene_restaurant_brunch.json.gz", *text, committed_knowledge(Simulator::Behavior), known);
    ASSERT_TRUE(scenes) << format(scenes.error());
    const auto all = import_all(*scenes, 1);
    EXPECT_EQ(all.front().report.objects, 167);
    EXPECT_GT(all.front().report.known, 40);
    EXPECT_GE(arrived_share(all.front().report), 0.95);
    EXPECT_EQ(all.front().report.relations, 0) << "the file states none";
    std::cout << table_row(known.empty() ? "behavior" : "behavior with the inventory", all) << "\n";
  }
}

TEST(Behavior, AModelThatStandsOnTheFloorSaysWhereItsBoxIsAboveItsRootLink) {
  const SourceScene scene = read(kFlat);
  EXPECT_NEAR(scene.objects[2].pose.position.z(), 0.45, 1e-9) << "half as high as it is tall";
  EXPECT_NEAR(scene.objects[3].pose.position.z(), 0.95, 1e-9) << "the other of that model is as far below its root";
  EXPECT_EQ(scene.objects[3].category, "armchair") << "its model was renamed since";
  EXPECT_THAT(scene.warnings, Contains(HasSubstr("2 objects are more than 2 cm from the height")));
}

TEST(Behavior, FrontsLookAlongXAndSizesFollow) {
  const SourceScene scene = read(kFlat);
  EXPECT_LT((scene.objects[2].pose.rotation * -Vec3::UnitY() - Vec3::UnitX()).norm(), 1e-9);
  EXPECT_LT((scene.objects[3].pose.rotation * -Vec3::UnitY() - Vec3::UnitY()).norm(), 1e-4);
  EXPECT_EQ(scene.objects[2].size, Vec3(0.8, 0.6, 0.9));
  EXPECT_NEAR(scene.objects[2].opening, 0.3 / (std::numbers::pi / 2), 1e-9);
}

TEST(Behavior, RoomsAreTheOutlinesOfTheirFloors) {
  const SourceScene scene = read(kFlat);
  ASSERT_EQ(scene.rooms.size(), 2U);
  EXPECT_EQ(scene.rooms[0].id, "kitchen_0");
  EXPECT_EQ(scene.rooms[0].type, "kitchen");
  ASSERT_EQ(scene.rooms[0].polygon.size(), 4U);
  EXPECT_LT((scene.rooms[0].polygon[2] - Vec2(4, 3)).norm(), 1e-9);
  EXPECT_LT((scene.rooms[1].polygon[0] - Vec2(4, 0)).norm(), 1e-9) << "both sides of a wall are one line";
}

TEST(Behavior, ARoomWithinAnotherIsAPartOfIt) {
  const SourceScene scene =
      read(replace_all(replace_all(kFlat, "[6.1, 1.5, -0.1]", "[2, 1.5, -0.1]"), "\"bbbbbb\", \"scale\": [1, 1, 1]",
                       "\"bbbbbb\", \"scale\": [0.5, 0.5, 1]"));
  ASSERT_EQ(scene.rooms.size(), 1U);
  EXPECT_EQ(scene.objects[3].room, "kitchen_0");
  EXPECT_THAT(scene.warnings, Contains(HasSubstr("living_room_0: inside another room")));
}

TEST(Behavior, ReadsOmniGibsonsOwnFormOfTwoReleases) {
  for (const bool nested : {false, true}) {
    const SourceScene scene = read(omnigibson(nested));
    ASSERT_EQ(scene.objects.size(), 1U);
    const SourceObject& chair = scene.objects.front();
    EXPECT_EQ(chair.id, "chair_1");
    EXPECT_EQ(chair.size, Vec3(0.9, 0.7, 1.0)) << "the box that the file asks for";
    EXPECT_EQ(chair.room, "kitchen_0");
    EXPECT_THAT(chair.states, Contains(State{Predicate::PowerOn, ""}));
    EXPECT_GT(chair.opening, 0.1);
    EXPECT_TRUE(scene.has_agent);
    EXPECT_NEAR(scene.agent.yaw, std::numbers::pi / 2, 1e-4);
    EXPECT_THAT(scene.warnings, Contains(HasSubstr("1 objects have no pose in the state, as gone")));
  }
}

TEST(Behavior, BadScenesGetAnErrorWithItsPlace) {
  const auto with = [](const std::string& text, const std::string& from, const std::string& to) {
    const auto scenes =
        read_behavior("scene.json", replace_all(text, from, to), committed_knowledge(Simulator::Behavior), models());
    return scenes ? std::string("accepted") : format(scenes.error());
  };
  EXPECT_EQ(with(kFlat, "[1, 1, 0.55]", "[1, 1]"),
            "scene.json#/objects/2/pos: schema error: expected [x, y, z], not 2 items");
  EXPECT_THAT(with(kFlat, "[1, 1, 0.55]", "[1, Infinity, 0.55]"), HasSubstr("scene.json:7:42: parse error"));
  EXPECT_EQ(with(kFlat, "\"name\": \"chair_1\", ", ""),
            "scene.json#/objects/2: schema error: the field \"name\" is missing");
  EXPECT_EQ(with(omnigibson(false), "\"root_link\"", "\"root\""),
            "scene.json#/state/object_registry/chair_1: schema error: the field \"root_link\" is missing");
  EXPECT_EQ(with(omnigibson(true), "\"objects_info\"", "\"objects_infos\""),
            "scene.json: schema error: the field \"objects_info\" is missing");
  EXPECT_EQ(with(omnigibson(true), "[0.7, 0.9, 1.0]", "[0.7, 0, 1.0]"),
            "scene.json#/objects_info/init_info/chair_1/args/bounding_box: schema error: expected three lengths > 0");
}

TEST(Behavior, WhatGoesOutComesInWithItsModelPoseAndSize) {
  const Knowledge& knowledge = committed_knowledge(Simulator::Behavior);
  std::size_t met = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const Scene home = small_home(knowledge, seed);
    const auto exported = write_behavior(home, knowledge);
    ASSERT_TRUE(exported) << format(exported.error());
    const auto json = nlohmann::json::parse(exported->text);
    const SceneModels none;
    const auto scenes = read_behavior("home.json", exported->text, knowledge, none);
    ASSERT_TRUE(scenes) << format(scenes.error());
    for (const Room& room : home.rooms) EXPECT_TRUE(exported->names.contains(room.id));
    for (const Node& node : home.nodes) {
      const auto name = exported->names.find(node.id);
      if (name == exported->names.end()) {
        EXPECT_THAT(exported->left_out, Contains(HasSubstr(node.id + ": no model of " + node.category)));
        continue;
      }
      const auto& objects = scenes->front().objects;
      const auto there =
          std::find_if(objects.begin(), objects.end(), [&](const auto& one) { return one.id == name->second; });
      ASSERT_NE(there, objects.end());
      ++met;
      EXPECT_EQ(there->category, node.category);
      EXPECT_LT((there->size - node.size).norm(), 1e-9);
      // The reader lowers and lifts things by the floor, so the height is held against the file itself.
      EXPECT_LT((there->pose.position - node.pose.position).head<2>().norm(), 1e-9);
      const auto& root = json["state"]["object_registry"][name->second]["root_link"];
      EXPECT_NEAR(root["pos"][2].get<double>(), node.pose.position.z(), 1e-12);
      EXPECT_LT(there->pose.rotation.angularDistance(node.pose.rotation), 1e-5);
      EXPECT_EQ(std::count(there->states.begin(), there->states.end(), State{Predicate::PowerOn, ""}),
                node.states.has(Predicate::PowerOn) ? 1 : 0);
    }
  }
  EXPECT_GT(met, 100U);
  EXPECT_FALSE(write_behavior(small_home(committed_knowledge(Simulator::Habitat), 1), knowledge));
}

}  // namespace
}  // namespace unietp::testing
