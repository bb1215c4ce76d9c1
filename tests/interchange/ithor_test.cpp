#include <cmath>
#include <cstdlib>
#include <iostream>

#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "import_rates.h"
#include "interchange/formats.h"
#include "tests/support/needs.h"

namespace unietp::testing {
namespace {

std::vector<SourceScene> real_scenes() {
  const auto text = read_maybe_gzip(upstream() / "ai2thor/ithor_scenes.json.gz");
  if (!text) return {};
  auto scenes = read_ithor("ithor_scenes.json.gz", *text);
  EXPECT_TRUE(scenes) << format(scenes.error());
  return scenes ? std::move(*scenes) : std::vector<SourceScene>{};
}

TEST(Ithor, RealScenesArriveAndHold) {
  const auto scenes = real_scenes();
  if (scenes.empty()) GTEST_SKIP() << needs::kSimulatorFiles;
  const char* whole = std::getenv("UNIETP_WHOLE_IMPORT");
  const auto all = import_all(scenes, whole ? 1 : 10);
  for (const auto& [scene, report, not_at_rest] : all) {
    SCOPED_TRACE(scene);
    EXPECT_GE(arrived_share(report), 0.95);
    EXPECT_GE(held_share(report), 0.9);
    EXPECT_LE(not_at_rest, 1u);
    if (!whole) continue;
    std::cout << scene << " objects " << report.objects << " known " << report.known << " arrived " << report.arrived
              << " stayed " << report.stayed << " relations " << report.relations << " held " << report.relations_held
              << " loose " << report.loose << " held " << report.loose_held << "\n";
    for (const auto& issue : report.issues) {
      std::cout << "  " << name_of(issue.reason) << ": " << issue.object << ": " << issue.detail << "\n";
    }
  }
  std::cout << table_row("ithor", all) << "\n";
}

/// As AI2-THOR gives it: event.metadata of one scene.
constexpr const char* kMetadata = R"({"sceneName": "FloorPlan1_physics",
"agent": {"position": {"x": 0, "y": 0.9, "z": -1}, "rotation": {"x": 0, "y": 90, "z": 0}, "cameraHorizon": 30},
"objects": [
{"objectId": "Floor|1", "objectType": "Floor", "position": {"x": 0, "y": 0.1, "z": 0}, "rotation": {"x": 0, "y": 0, "z": 0},
 "axisAlignedBoundingBox": {"center": {"x": 0, "y": 0.05, "z": 0}, "size": {"x": 5, "y": 0.1, "z": 4}},
 "objectOrientedBoundingBox": null, "parentReceptacles": null},
{"objectId": "Table|1", "objectType": "DiningTable", "position": {"x": 1, "y": 0.1, "z": 0.5},
 "rotation": {"x": 0, "y": 90, "z": 0}, "parentReceptacles": ["Floor|1"],
 "axisAlignedBoundingBox": {"center": {"x": 1, "y": 0.5, "z": 0.5}, "size": {"x": 0.8, "y": 0.8, "z": 1.4}}},
{"objectId": "Mug|1", "objectType": "Mug", "position": {"x": 1, "y": 0.9, "z": 0.5}, "rotation": {"x": 0, "y": 0, "z": 0},
 "isDirty": true, "isFilledWithLiquid": true, "fillLiquid": "coffee", "temperature": "Hot", "mass": 0.5,
 "parentReceptacles": ["Table|1"],
 "axisAlignedBoundingBox": {"center": {"x": 1, "y": 0.95, "z": 0.5}, "size": {"x": 0.1, "y": 0.1, "z": 0.12}},
 "objectOrientedBoundingBox": {"cornerPoints": [[1.05, 1.0, 0.56], [1.05, 1.0, 0.44], [1.05, 0.9, 0.56],
  [1.05, 0.9, 0.44], [0.95, 1.0, 0.56], [0.95, 1.0, 0.44], [0.95, 0.9, 0.56], [0.95, 0.9, 0.44]]}}]})";

TEST(Ithor, TheSimulatorsOwnMetadataReadsAsADumpDoes) {
  for (const std::string& text : {std::string(kMetadata), "{\"metadata\": " + std::string(kMetadata) + "}"}) {
    const auto scenes = read_ithor("event", text);
    ASSERT_TRUE(scenes) << format(scenes.error());
    ASSERT_EQ(scenes->size(), 1u);
    const SourceScene& scene = scenes->front();
    EXPECT_EQ(scene.id, "FloorPlan1_physics");
    ASSERT_EQ(scene.rooms.size(), 1u);
    EXPECT_EQ(scene.rooms[0].type, "kitchen");
    const SourceObject& table = scene.objects[1];
    EXPECT_LT((table.size - Vec3(1.4, 0.8, 0.8)).norm(), 1e-9) << "turned by a quarter";
    EXPECT_LT((table.pose.position - Vec3(1, 0.5, 0.4)).norm(), 1e-9) << "heights count from the floor";
    const SourceObject& mug = scene.objects[2];
    EXPECT_LT((mug.size - Vec3(0.1, 0.12, 0.1)).norm(), 1e-9);
    EXPECT_THAT(mug.states, ::testing::UnorderedElementsAre(State{Predicate::Dirty, ""}, State{Predicate::Hot, ""},
                                                            State{Predicate::Filled, "coffee"}));
    ASSERT_TRUE(scene.has_agent);
    EXPECT_NEAR(scene.agent.yaw, 0, 1e-9) << "Unity's 90 degrees look along x";
    const auto home =
        assemble(scene, committed_knowledge(Simulator::Ai2thor), profile_of(Simulator::Ai2thor), format_facts());
    ASSERT_TRUE(home) << format(home.error());
    EXPECT_EQ(home->report.arrived, 3);
    EXPECT_EQ(home->report.relations_held, 2);
    EXPECT_TRUE(find_node(home->scene, "mug_1")->states.has(State{Predicate::Filled, "coffee"}));
  }
}

TEST(Ithor, BadTextIsRefusedWithItsPlace) {
  const auto message = [](std::string_view text) {
    const auto scenes = read_ithor("dump", text);
    return scenes ? "accepted" : format(scenes.error());
  };
  EXPECT_THAT(message("{\"objects\": [\n  {\"objectId\": NaN}]}"), ::testing::StartsWith("dump:2:16: parse error"));
  EXPECT_THAT(message("{\"objects\": [{\"objectId\": 5, \"objectType\": \"Mug\"}]}"),
              ::testing::StartsWith("dump#/objects/0/objectId: "));
  EXPECT_THAT(message("{\"objects\": [{\"objectId\": \"a\", \"objectType\": \"Mug\"}]}"),
              ::testing::HasSubstr("the field \"position\" is missing"));
  EXPECT_THAT(message("{\"objects\": [{\"objectId\": \"a\", \"objectType\": \"Mug\", \"position\": [1, 2]}]}"),
              ::testing::HasSubstr("dump#/objects/0/position"));
  EXPECT_THAT(message("{\"objects\": [{\"objectId\": \"a\", \"objectType\": \"Mug\", \"position\": [1, 2, 1e999]}]}"),
              ::testing::HasSubstr("parse error"));
  EXPECT_THAT(message("{}"), ::testing::HasSubstr("the field \"objects\" is missing"));
  EXPECT_THAT(message("5"), ::testing::HasSubstr("expected an object"));
}

TEST(Ithor, ATruncatedFileIsRefusedByItsName) {
  const auto path = std::filesystem::temp_directory_path() / ("unietp-cut-" + std::to_string(getpid()) + ".json.gz");
  const std::string packed = gzip(kMetadata);
  ASSERT_TRUE(write_file(path, packed.substr(0, packed.size() / 2)));
  const auto text = read_maybe_gzip(path);
  std::filesystem::remove(path);
  ASSERT_FALSE(text);
  EXPECT_THAT(format(text.error()), ::testing::HasSubstr("unietp-cut-"));
}

}  // namespace
}  // namespace unietp::testing
