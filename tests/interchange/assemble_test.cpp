#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/files.h"
#include "import_rates.h"
#include "interchange/formats.h"
#include "interchange/import_scene.h"
#include "simulation/relations.h"

namespace unietp::testing {
namespace {

using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

SourceObject thing(const std::string& id, const std::string& category, const Vec3& center, const Vec3& size,
                   const std::string& holder = "") {
  SourceObject object;
  object.id = id;
  object.category = category;
  object.pose.position = center;
  object.size = size;
  if (!holder.empty()) object.held_by.push_back({SourceRelation::Kind::OnOrInside, holder});
  return object;
}

/// A kitchen of 4 x 4 m: a counter whose box is 20 cm higher than what stands on it, with a sink sunk into it.
SourceScene kitchen() {
  SourceScene scene;
  scene.id = "kitchen";
  scene.rooms.push_back({"kitchen_1", "kitchen", {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}});
  scene.objects.push_back(thing("counter", "CounterTop", {0, 1.6, 0.55}, {3, 0.6, 1.1}));
  scene.objects.push_back(thing("sink", "Sink", {0.8, 1.6, 0.8}, {0.6, 0.5, 0.2}));
  scene.objects.push_back(thing("mug", "Mug", {-0.8, 1.6, 0.95}, {0.1, 0.1, 0.1}, "counter"));
  scene.objects.push_back(thing("apple", "Apple", {-0.4, 1.6, 0.945}, {0.08, 0.08, 0.08}, "counter"));
  scene.objects.push_back(thing("cup", "Cup", {0.8, 1.6, 0.82}, {0.08, 0.08, 0.1}, "sink"));
  return scene;
}

Result<ImportedScene> imported(const SourceScene& scene, const ImportOptions& options = {}) {
  return assemble(scene, committed_knowledge(Simulator::Ai2thor), profile_of(Simulator::Ai2thor), format_facts(),
                  options);
}

std::vector<std::string> reasons_of(const ImportReport& report) {
  std::vector<std::string> reasons;
  for (const ImportIssue& issue : report.issues) reasons.emplace_back(name_of(issue.reason));
  return reasons;
}

TEST(Assemble, FurnitureFollowsWhatTheFileShowsToStandOnIt) {
  const auto home = imported(kitchen());
  ASSERT_TRUE(home) << format(home.error());
  EXPECT_EQ(home->report.known, 5);
  EXPECT_EQ(home->report.arrived, 5);
  EXPECT_EQ(home->report.stayed, 5);
  EXPECT_EQ(home->report.relations, 3);
  EXPECT_EQ(home->report.relations_held, 3);
  EXPECT_TRUE(has_edge(home->scene, Predicate::On, "mug_1", "counter_top_1"));
  EXPECT_THAT(restless(home->scene), IsEmpty());
  EXPECT_TRUE(find_node(home->scene, "mug_1")->boards.empty());
  EXPECT_FALSE(find_node(home->scene, "counter_top_1")->boards.empty());
}

/// The first repair of this kind of the object, as the file names it.
ImportRepair repair_of(const ImportReport& report, const std::string& object, RepairKind kind) {
  for (const ImportRepair& repair : report.repairs) {
    if (repair.object == object && repair.kind == kind) return repair;
  }
  ADD_FAILURE() << object << " has no repair " << name_of(kind);
  return {};
}

TEST(Assemble, EveryRepairIsReportedWithItsDistance) {
  SourceScene scene = kitchen();
  scene.objects.push_back(thing("table", "DiningTable", {0, -1, 0.4}, {1, 0.8, 0.8}));
  scene.objects.push_back(thing("plate", "Plate", {0, -1, 0.81}, {0.2, 0.2, 0.02}, "table"));
  scene.objects.push_back(thing("book", "Book", {0.3, -1, 0.828}, {0.1, 0.1, 0.04}, "table"));
  scene.objects.push_back(thing("vase", "Vase", {-0.3, -1, 1.05}, {0.1, 0.1, 0.2}, "table"));
  scene.objects.push_back(thing("pillow", "Pillow", {-1, 0, 0.15}, {0.3, 0.3, 0.2}));
  const auto home = imported(scene);
  ASSERT_TRUE(home) << format(home.error());
  const ImportReport& report = home->report;
  const ImportRepair surface = repair_of(report, "counter", RepairKind::Surface);
  EXPECT_NEAR(surface.by_m, 0.2, 0.02) << "what stands on the counter is 20 cm below the top of its box";
  EXPECT_EQ(surface.node, "counter_top_1");
  const ImportRepair cut = repair_of(report, "counter", RepairKind::Cut);
  EXPECT_EQ(cut.other, "sink");
  EXPECT_NEAR(cut.by_m, 0.4, 0.02) << "the sink's bottom is 40 cm below the counter's top, before that is moved";
  EXPECT_NEAR(repair_of(report, "book", RepairKind::Lowered).by_m, 0.008, 0.001) << "8 mm above the plate's level";
  const ImportRepair board = repair_of(report, "table", RepairKind::Board);
  EXPECT_EQ(board.other, "vase");
  EXPECT_NEAR(board.by_m, 0.15, 0.02) << "the air between vase and table";
  EXPECT_NEAR(repair_of(report, "pillow", RepairKind::Settled).by_m, 0.05, 0.005) << "it hung 5 cm above the floor";
  for (const ImportRepair& repair : report.repairs) EXPECT_GE(repair.by_m, 0.001) << repair.object;
}

std::vector<std::string> kinds_of(const ImportReport& report) {
  std::vector<std::string> kinds;
  for (const ImportRepair& repair : report.repairs)
    kinds.push_back(repair.object + " " + std::string(name_of(repair.kind)));
  return kinds;
}

TEST(Assemble, FurnitureThatReachesBelowTheFloorIsCutOffThere) {
  SourceScene scene = kitchen();
  scene.objects.push_back(thing("fridge", "Fridge", {-1, -1, 0.87}, {0.7, 0.7, 1.8}));  // 3 cm too low
  const auto home = imported(scene);
  ASSERT_TRUE(home) << format(home.error());
  EXPECT_THAT(kinds_of(home->report), Contains("fridge cut"));
  const auto& nodes = home->scene.nodes;
  const auto fridge = std::find_if(nodes.begin(), nodes.end(), [](const Node& n) { return n.category == "Fridge"; });
  ASSERT_NE(fridge, nodes.end());
  EXPECT_NEAR(fridge->pose.position.z() - fridge->size.z() / 2, 0, 1e-9);
  EXPECT_NEAR(fridge->pose.position.z() + fridge->size.z() / 2, 1.77, 1e-9);
}

TEST(Assemble, ACabinetThatFacesTheWallIsTurnedToWhereItOpens) {
  SourceScene scene = kitchen();
  scene.objects.push_back(thing("shut", "Cabinet", {-1, -1.74, 0.4}, {0.6, 0.5, 0.8}));  // its front, -y, at the wall
  scene.objects.push_back(thing("free", "Cabinet", {1, -0.5, 0.4}, {0.6, 0.5, 0.8}));
  const auto home = imported(scene);
  ASSERT_TRUE(home) << format(home.error());
  EXPECT_THAT(kinds_of(home->report), Contains("shut turned"));
  EXPECT_THAT(kinds_of(home->report), Not(Contains("free turned")));
  const Node& shut = home->scene.nodes[5];
  ASSERT_EQ(shut.category, "Cabinet");
  EXPECT_GT((shut.pose * Vec3(0, -1, 0)).y(), shut.pose.position.y()) << "into the room";
  EXPECT_TRUE(shut.size.isApprox(Vec3(0.6, 0.5, 0.8)));
}

TEST(Assemble, WhatIsALittleInTheWayOfADrawerIsCut) {
  SourceScene scene = kitchen();
  scene.objects.push_back(thing("dresser", "Dresser", {0, -1.2, 0.4}, {0.8, 0.5, 0.8}));
  scene.objects.push_back(thing("drawer", "Drawer", {0, -1.19, 0.6}, {0.6, 0.44, 0.2}));  // 4 cm behind its front
  const auto home = imported(scene);
  ASSERT_TRUE(home) << format(home.error());
  const auto& repairs = home->report.repairs;
  EXPECT_TRUE(std::any_of(repairs.begin(), repairs.end(), [](const ImportRepair& repair) {
    return repair.kind == RepairKind::Cut && repair.object == "dresser" && repair.other == "drawer" &&
           repair.by_m < 0.1;
  }));
}

TEST(Assemble, IsDeterministic) {
  const auto one = imported(kitchen()), two = imported(kitchen());
  ASSERT_TRUE(one && two);
  EXPECT_EQ(one->scene, two->scene);
}

TEST(Assemble, WithoutRoomsOneIsDrawnAndTheAgentStandsOnFreeFloor) {
  SourceScene scene = kitchen();
  scene.rooms.clear();
  scene.objects.push_back(thing("table", "DiningTable", {0, -1, 0.4}, {1, 0.8, 0.8}));
  const auto home = imported(scene);
  ASSERT_TRUE(home) << format(home.error());
  ASSERT_EQ(home->scene.rooms.size(), 1u);
  EXPECT_EQ(home->report.rooms_drawn, 1);
  EXPECT_TRUE(contains(home->scene.rooms[0].polygon, home->scene.agent.position));
}

TEST(Assemble, RoomsWithoutDoorsAreJoinedWhereTheyShareAWall) {
  SourceScene scene = kitchen();
  scene.rooms.push_back({"bedroom_1", "bedroom", {{2.1, -2}, {5, -2}, {5, 2}, {2.1, 2}}});
  scene.rooms.push_back({"shed_1", "shed", {{9, -2}, {12, -2}, {12, 2}, {9, 2}}});
  const auto home = imported(scene);
  ASSERT_TRUE(home) << format(home.error());
  EXPECT_EQ(home->scene.openings.size(), 2u) << "the wall has two sides";
  EXPECT_EQ(home->report.openings_made, 2);
  EXPECT_EQ(home->report.rooms_drawn, 0);
  ASSERT_THAT(reasons_of(home->report), Contains("cut-off"));
  EXPECT_EQ(home->report.issues.front().object, "shed_1");
}

TEST(Assemble, TheReasonsAreThoseOfTheSchema) {
  const auto text = read_file(std::filesystem::path(UNIETP_SOURCE_DIR) / "data/schemas/import.schema.json");
  ASSERT_TRUE(text);
  const auto schema = nlohmann::json::parse(*text);
  const auto& names = schema.at("/properties/issues/items/properties/reason/enum"_json_pointer);
  for (std::size_t i = 0; i < names.size(); ++i) EXPECT_EQ(name_of(static_cast<ImportReason>(i)), names[i]);
  EXPECT_EQ(names.size(), static_cast<std::size_t>(ImportReason::UnknownState) + 1);
  const auto& repairs = schema.at("/properties/repairs/items/properties/repair/enum"_json_pointer);
  for (std::size_t i = 0; i < repairs.size(); ++i) EXPECT_EQ(name_of(static_cast<RepairKind>(i)), repairs[i]);
  EXPECT_EQ(repairs.size(), static_cast<std::size_t>(RepairKind::Turned) + 1);
}

TEST(Assemble, WhatCannotBePlacedIsListedByItsReason) {
  SourceScene scene = kitchen();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  scene.objects.push_back(thing("nowhere", "Mug", {nan, 0, 0}, {0.1, 0.1, 0.1}));
  scene.objects.push_back(thing("far", "Mug", {1e300, 0, 0}, {0.1, 0.1, 0.1}));
  scene.objects.push_back(thing("huge", "Mug", {0, 0, 0.1}, {0.1, 0.1, 1e9}));
  scene.objects.push_back(thing("garden", "Mug", {7, 7, 0.05}, {0.1, 0.1, 0.1}));
  scene.objects.push_back(thing("what", "Flumbus", {0, 0, 0.1}, {0.1, 0.1, 0.1}));
  scene.objects.push_back(thing("mug", "Mug", {0, 0, 0.05}, {0.1, 0.1, 0.1}));
  scene.objects.push_back(thing("boxless", "Plate", {0, -1, 0.01}, {0, 0, 0}));
  scene.objects.push_back(thing("bowl", "Bowl", {0.5, -1, 0.04}, {0.2, 0.2, 0.08}, "pot"));
  scene.objects.push_back(thing("pot", "Pot", {0.5, -1, 0.1}, {0.3, 0.3, 0.2}, "bowl"));
  scene.objects.push_back(thing("lost", "Book", {-1, -1, 0.02}, {0.2, 0.2, 0.04}, "shelf_of_nobody"));
  const auto home = imported(scene);
  ASSERT_TRUE(home) << format(home.error());
  for (const char* reason : {"not-finite", "too-far", "outside-rooms", "unknown-category", "duplicate-id",
                             "typical-size", "cyclic-containment", "unknown-receptacle"}) {
    EXPECT_THAT(reasons_of(home->report), Contains(reason));
  }
  EXPECT_EQ(home->report.objects, 15);
  EXPECT_EQ(home->report.known, 14);
  EXPECT_EQ(home->report.placed, 9);
}

TEST(Assemble, AFileWithNothingToPlaceOrTooMuchIsRefused) {
  SourceScene scene = kitchen();
  const auto few = imported(scene, {.settle = true, .most_objects = 4});
  ASSERT_FALSE(few);
  EXPECT_EQ(few.error().message, "5 objects; accepted are at most 4");
  for (SourceObject& object : scene.objects) object.category = "Flumbus";
  const auto nothing = imported(scene);
  ASSERT_FALSE(nothing);
  EXPECT_EQ(nothing.error().message, "no object of a known category can be placed");
  for (SourceObject& object : scene.objects) object.category.clear();
  const auto hashes = imported(scene);
  ASSERT_FALSE(hashes);
  EXPECT_THAT(hashes.error().message, HasSubstr("needs a table of their categories (--assets)"));
}

TEST(Assemble, ARoomAsWideAsATownIsRefused) {
  SourceScene scene = kitchen();
  scene.rooms[0].polygon[1].x() = 1e12;
  const auto home = imported(scene);
  ASSERT_FALSE(home);
  EXPECT_THAT(home.error().message, HasSubstr("accepted are at most 200 m"));
}

TEST(Assemble, AHeapIsFixedInPlaceAndNothingElse) {
  SourceScene scene = kitchen();
  for (int i = 0; i < 64; ++i)
    scene.objects.push_back(thing("box" + std::to_string(i), "Box",
                                  {-1 + 0.07 * (i % 4), -1 + 0.07 * (i / 4 % 4), 0.1 + 0.07 * (i / 16)},
                                  {0.15, 0.15, 0.15}));
  const auto home = imported(scene);
  ASSERT_TRUE(home) << format(home.error());
  for (const Node& node : home->scene.nodes) {
    EXPECT_FALSE(node.movable && node.category == "Box") << node.id;
    EXPECT_TRUE(node.movable || (node.category != "Mug" && node.category != "Apple")) << node.id;
    EXPECT_TRUE(node.category != "Box" || node.boards.empty()) << node.id;
  }
  EXPECT_EQ(home->report.stayed, home->report.arrived);
  EXPECT_EQ(std::ranges::count(reasons_of(home->report), "restless"), 64);
  EXPECT_THAT(home->report.issues.front().detail, HasSubstr("part of a heap"));
}

TEST(Assemble, AHomeThatTakesTooMuchWorkStaysWhereTheFileHasItFixedInPlace) {
  const auto home = imported(kitchen(), {.most_work = 50});
  ASSERT_TRUE(home) << format(home.error());
  for (const Node& node : home->scene.nodes) EXPECT_FALSE(node.movable) << node.id;
  EXPECT_EQ(std::ranges::count(reasons_of(home->report), "restless"), 3) << "mug, apple and cup";
  EXPECT_THAT(home->report.issues.front().detail, HasSubstr("too crowded"));
}

TEST(Assemble, AMillionObjectsAreRefusedAtOnce) {
  SourceScene scene = kitchen();
  scene.objects.resize(1'000'000);
  const auto home = imported(scene);
  ASSERT_FALSE(home);
  EXPECT_THAT(home.error().message, HasSubstr("at most 5000"));
}

}  // namespace
}  // namespace unietp::testing
