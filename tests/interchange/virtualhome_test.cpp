#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>
#include <numbers>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/text.h"
#include "import_rates.h"
#include "interchange/formats.h"
#include "interchange/virtualhome_prefab.h"
#include "interchange/virtualhome_words.h"
#include "small_home.h"
#include "tests/support/needs.h"

namespace unietp::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using Json = nlohmann::json;

Result<std::vector<SourceScene>> read(const std::string& text) {
  return read_virtualhome("home.json", text, committed_knowledge(Simulator::Virtualhome), format_facts());
}

/// A kitchen of two tiles with a bedroom beside it, the frame of a door between them, a fridge at the kitchen's wall
/// with a plate in it, a table with a mug on it.
const std::string kFlat = R"({"nodes": [
  {"id": 1, "class_name": "kitchen", "category": "Rooms", "bbox_center": [2.2, 1.25, 1.5], "bbox_size": [4.8, 2.5, 3]},
  {"id": 2, "class_name": "bedroom", "category": "Rooms", "bbox_center": [5.5, 1.25, 1.5], "bbox_size": [3, 2.5, 3]},
  {"id": 3, "class_name": "floor", "category": "Floor", "bbox_center": [1, 0, 1.5], "bbox_size": [2, 0, 3]},
  {"id": 4, "class_name": "floor", "category": "Floor", "bbox_center": [3, 0, 1.5], "bbox_size": [2, 0, 3]},
  {"id": 5, "class_name": "floor", "category": "Floor", "bbox_center": [5.51, 0, 1.5], "bbox_size": [2.98, 0, 3]},
  {"id": 6, "class_name": "doorjamb", "category": "Doors", "bbox_center": [4.02, 1, 1], "bbox_size": [0.12, 2, 0.9]},
  {"id": 7, "class_name": "fridge", "category": "Appliances", "prefab_name": "no_such_prefab",
   "states": ["OPEN", "SITTING"], "bbox_center": [1, 0.9, 0.4], "bbox_size": [0.8, 1.8, 0.7]},
  {"id": 8, "class_name": "plate", "category": "Props", "bbox_center": [1, 0.91, 0.4], "bbox_size": [0.2, 0.02, 0.2]},
  {"id": 9, "class_name": "kitchentable", "category": "Furniture", "bbox_center": [2, 0.4, 2],
   "bbox_size": [1.5, 0.8, 0.9]},
  {"id": 10, "class_name": "mug", "category": "Props", "bbox_center": [2, 0.85, 2], "bbox_size": [0.1, 0.1, 0.1]},
  {"id": 11, "class_name": "character", "category": "Characters", "bbox_center": [3, 0.8, 1],
   "bbox_size": [0.5, 1.6, 0.5]}],
 "edges": [[3, "INSIDE", 1], [4, "INSIDE", 1], [5, "INSIDE", 2], [6, "BETWEEN", 1], [6, "BETWEEN", 2],
  [7, "INSIDE", 1], [8, "INSIDE", 1], [9, "INSIDE", 1], [10, "INSIDE", 1], [8, "INSIDE", 7], [10, "ON", 9],
  [10, "CLOSE", 9], [99, "ON", 9]]})";

SourceScene flat() {
  const auto scenes = read(kFlat);
  EXPECT_TRUE(scenes) << format(scenes.error());
  EXPECT_EQ(scenes->size(), 1U);
  return scenes->front();
}

/// The same graph as upstream writes it.
std::string unflattened() {
  Json json = Json::parse(kFlat);
  for (Json& node : json["nodes"]) {
    node["bounding_box"] = {{"center", node["bbox_center"]}, {"size", node["bbox_size"]}};
    node.erase("bbox_center"), node.erase("bbox_size");
    node["obj_transform"] = nullptr;
  }
  for (Json& edge : json["edges"]) {
    edge = {{"from_id", edge[0]}, {"relation_type", edge[1]}, {"to_id", edge[2]}};
  }
  return json.dump();
}

const SourceObject& object(const SourceScene& scene, const std::string& id) {
  const auto found =
      std::find_if(scene.objects.begin(), scene.objects.end(), [&](const SourceObject& o) { return o.id == id; });
  EXPECT_NE(found, scene.objects.end()) << id;
  return *found;
}

TEST(Virtualhome, RealHomesArriveAndHold) {
  const char* whole = std::getenv("UNIETP_WHOLE_IMPORT");  // all homes, for a long run
  std::vector<Imported> all;
  for (int i = 1; i <= (whole != nullptr ? 6 : 1); ++i) {
    const std::string name = "TestScene" + std::to_string(i) + ".json.gz";
    const auto text = read_maybe_gzip(upstream() / "virtualhome/scenes" / name);
    if (!text) GTEST_SKIP() << needs::kSimulatorFiles;
    const auto scenes = read_virtualhome(name, *text, committed_knowledge(Simulator::Virtualhome), format_facts());
    ASSERT_TRUE(scenes) << format(scenes.error());
    EXPECT_EQ(scenes->front().id, "TestScene" + std::to_string(i));
    EXPECT_GE(scenes->front().rooms.size(), 4U);
    EXPECT_GE(scenes->front().openings.size(), 3U);
    for (Imported& one : import_all(*scenes, 1)) all.push_back(std::move(one));
  }
  for (const auto& [scene, report, restless] : all) {
    SCOPED_TRACE(scene);
    EXPECT_GE(arrived_share(report), 0.95);
    EXPECT_GE(held_share(report), 0.9);
  }
  std::cout << table_row("virtualhome", all) << "\n";
}

TEST(Virtualhome, ATrimmedGraphHasNoBoxesAndTheErrorSaysSo) {
  const auto text = read_maybe_gzip(upstream() / "virtualhome/scenes/TrimmedTestScene1.json.gz");
  if (!text) GTEST_SKIP() << needs::kSimulatorFiles;
  const auto scenes = read(*text);
  ASSERT_FALSE(scenes);
  EXPECT_THAT(format(scenes.error()), HasSubstr("no node has a bounding box"));
}

TEST(Virtualhome, RoomsFollowTheirFloorsAndNeighborsShareAWall) {
  const SourceScene scene = flat();
  ASSERT_EQ(scene.rooms.size(), 2U);
  EXPECT_EQ(scene.rooms[0].type, "kitchen");
  EXPECT_THAT(scene.rooms[0].polygon, ElementsAre(Vec2(0, 0), Vec2(4, 0), Vec2(4, 3), Vec2(0, 3)));
  EXPECT_THAT(scene.rooms[1].polygon, ElementsAre(Vec2(4, 0), Vec2(7, 0), Vec2(7, 3), Vec2(4, 3)));
  ASSERT_EQ(scene.openings.size(), 1U);
  EXPECT_NEAR((scene.openings[0].from - scene.openings[0].to).norm(), 0.9, 1e-9);
  EXPECT_EQ(scene.openings[0].from.x(), 4) << "on the line of the wall";
  EXPECT_EQ(scene.openings[0].height, 2);
  EXPECT_EQ(scene.wall_height, 2.5);
}

TEST(Virtualhome, TellsWhatIsOnAndInWhatAndWhatItLeavesOut) {
  const SourceScene scene = flat();
  const SourceObject &mug = object(scene, "10"), &plate = object(scene, "8"), &fridge = object(scene, "7");
  ASSERT_EQ(mug.held_by.size(), 1U);
  EXPECT_EQ(mug.held_by[0].receptacle, "9");
  EXPECT_EQ(mug.held_by[0].kind, SourceRelation::Kind::On);
  ASSERT_EQ(plate.held_by.size(), 1U);
  EXPECT_EQ(plate.held_by[0].kind, SourceRelation::Kind::Inside);
  EXPECT_EQ(mug.room, scene.rooms[0].id);
  EXPECT_THAT(fridge.states, ElementsAre(State{Predicate::Open, ""}));
  EXPECT_EQ(fridge.opening, 1);
  EXPECT_TRUE(scene.has_agent);
  EXPECT_EQ(scene.agent.position, Vec2(3, 1));
  EXPECT_THAT(scene.warnings, Contains(HasSubstr("SITTING")));
  EXPECT_THAT(scene.warnings, Contains(HasSubstr("1 edges refer to a node that is not in the graph")));
}

TEST(Virtualhome, FurnitureTurnsItsBackToTheNearestWall) {
  const SourceObject fridge = object(flat(), "7");
  const Vec3 back = fridge.pose.rotation * Vec3::UnitY();
  EXPECT_LT((back - -Vec3::UnitY()).norm(), 1e-9) << "the wall is at y = 0";
  EXPECT_LT((fridge.size - Vec3(0.8, 0.7, 1.8)).norm(), 1e-9);
}

TEST(Virtualhome, ReadsUpstreamsOwnFormAndTheFlatOneAlike) {
  const auto own = read(unflattened());
  ASSERT_TRUE(own) << format(own.error());
  const SourceScene scene = flat();
  ASSERT_EQ(own->front().objects.size(), scene.objects.size());
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const SourceObject &a = scene.objects[i], &b = own->front().objects[i];
    EXPECT_EQ(a.pose, b.pose);
    EXPECT_EQ(a.size, b.size);
    EXPECT_EQ(a.held_by.size(), b.held_by.size());
  }
}

TEST(Virtualhome, ARotationInTheFileWinsOverTheWallAndSolvesTheBox) {
  // A thing of 1 m by 0.4 m by 0.5 m, turned by 30° in Unity.
  const double turn = std::numbers::pi / 6, c = std::cos(turn), s = std::sin(turn);
  Json json = Json::parse(kFlat);
  json["nodes"][6]["bbox_size"] = {c * 1.0 + s * 0.4, 0.5, s * 1.0 + c * 0.4};
  json["nodes"][6]["obj_transform"] = {{"rotation", {0, std::sin(turn / 2), 0, std::cos(turn / 2)}}};
  const auto scenes = read(json.dump());
  ASSERT_TRUE(scenes) << format(scenes.error());
  const SourceObject& fridge = object(scenes->front(), "7");
  EXPECT_LT((fridge.size - Vec3(1, 0.4, 0.5)).norm(), 1e-9);
  // Unity's forward, z, turned clockwise from above: the front of the thing.
  EXPECT_LT((fridge.pose.rotation * -Vec3::UnitY() - Vec3(s, c, 0)).norm(), 1e-9);
}

TEST(Virtualhome, WhatGoesOutComesInTheSameForAnySeed) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const Scene home = small_home(committed_knowledge(Simulator::Virtualhome), seed);
    const auto exported = write_virtualhome(home, committed_knowledge(Simulator::Virtualhome), format_facts());
    ASSERT_TRUE(exported) << format(exported.error());
    const auto scenes = read(exported->text);
    ASSERT_TRUE(scenes) << format(scenes.error());
    const auto again = assemble(scenes->front(), committed_knowledge(Simulator::Virtualhome),
                                profile_of(Simulator::Virtualhome), format_facts(), {.settle = false});
    ASSERT_TRUE(again) << format(again.error());
    EXPECT_THAT(differences(home, again->scene, 1e-6), IsEmpty());
  }
}

Node of_class(const std::string& category, const Vec3& size) {
  Node node;
  node.id = category + "_1", node.category = category, node.size = size;
  return node;
}

TEST(Virtualhome, AThingOfOursHasTheNearestPrefabOfItsClass) {
  const Knowledge& knowledge = committed_knowledge(Simulator::Virtualhome);
  const auto prefab = [&](const Node& node) { return virtualhome_prefab(node, knowledge, format_facts()).name; };
  const Asset& fridge = *knowledge.asset_rows_of("fridge").back();
  const Asset* const nearest = knowledge.asset(prefab(of_class("fridge", fridge.size)));
  ASSERT_NE(nearest, nullptr);
  EXPECT_EQ(nearest->category, "fridge");
  EXPECT_EQ(nearest->size, fridge.size) << "which several have";
  EXPECT_FALSE(prefab(of_class("fridge", 5 * fridge.size)).empty()) << "is scaled, however odd the size";
  EXPECT_EQ(prefab(of_class("washingmachine", {0.6, 0.6, 0.9})), "Dark_Grey_Washing_Machine") << "of the table";
  EXPECT_EQ(prefab(of_class("kitchencabinet", {0.6, 0.6, 0.9})), "kitchen_cabinet") << "of unknown size";
  Node own = of_class("fridge", fridge.size);
  own.asset = "PRE_APP_Their_own";
  EXPECT_EQ(prefab(own), own.asset);
  FormatFacts none = format_facts();
  none.virtualhome_prefabs.clear();
  EXPECT_EQ(virtualhome_prefab(of_class("kitchencabinet", {1, 1, 1}), knowledge, none).name, "");
  for (const Category& category : knowledge.categories())
    EXPECT_FALSE(prefab(of_class(category.name, category.size)).empty()) << category.name;
}

TEST(Virtualhome, APrefabIsScaledToTheBoxOfTheThing) {
  Scene home = small_home(committed_knowledge(Simulator::Virtualhome), 1);
  home.nodes.clear();
  home.edges.clear();
  Node node = of_class("washingmachine", {1, 0.5, 2});
  node.pose = upright({1, 1, 1}, 0.3);
  home.nodes.push_back(node);
  const auto exported = write_virtualhome(home, committed_knowledge(Simulator::Virtualhome), format_facts());
  ASSERT_TRUE(exported) << format(exported.error());
  const Json graph = Json::parse(exported->text);
  Json machine;
  for (const Json& one : graph["nodes"]) {
    if (one["class_name"] == "washingmachine") machine = one;
  }
  EXPECT_EQ(machine["prefab_name"], "Dark_Grey_Washing_Machine");
  const Vec3 its = size_of_prefab("Dark_Grey_Washing_Machine", "washingmachine",
                                  committed_knowledge(Simulator::Virtualhome), format_facts())
                       .value();
  const auto scale = machine["obj_transform"]["scale"].get<std::vector<double>>();  // along its x, up, its z
  EXPECT_NEAR(scale.at(0) * its.x(), 1, 1e-9);
  EXPECT_NEAR(scale.at(1) * its.z(), 2, 1e-9);
  EXPECT_NEAR(scale.at(2) * its.y(), 0.5, 1e-9);
}

TEST(Virtualhome, ThePrefabsOfTheTableAreUpstreams) {
  const auto text = read_maybe_gzip(upstream() / "virtualhome/PrefabClass.json");
  if (!text) GTEST_SKIP() << needs::kSimulatorFiles;
  std::map<std::string, std::set<std::string>> theirs;
  const Json upstreams = Json::parse(*text);
  for (const Json& row : upstreams["prefabClasses"]) {
    std::string name = lower(row["className"].get<std::string>());
    std::erase(name, '_');
    for (const Json& prefab : row["prefabs"]) theirs[name].insert(prefab.get<std::string>());
  }
  for (const auto& [name, prefabs] : format_facts().virtualhome_prefabs) {
    for (const Prefab& prefab : prefabs) EXPECT_TRUE(theirs[name].contains(prefab.name)) << name << ": " << prefab.name;
  }
}

TEST(Virtualhome, ExportsUpstreamsWordsForPropertiesStatesAndRelations) {
  Scene home = small_home(committed_knowledge(Simulator::Virtualhome), 1);
  home.nodes.clear();
  const auto add = [&](const std::string& id, const std::string& category, Vec3 position) {
    Node node;
    node.id = id, node.category = category,
    node.size = committed_knowledge(Simulator::Virtualhome).find(category)->size;
    node.pose = upright(position, 0);
    home.nodes.push_back(node);
  };
  add("fridge_1", "fridge", {1, 1, 1});
  add("plate_1", "plate", {1, 1, 1});
  home.nodes.edit(0).openable = true;
  home.nodes.edit(0).states.set({Predicate::Open, ""});
  home.nodes.edit(1).states.set({Predicate::Hot, ""});
  home.edges = {{Predicate::Inside, "plate_1", "fridge_1"},
                {Predicate::OnFloor, "fridge_1", "kitchen_1"},
                {Predicate::InRoom, "fridge_1", "kitchen_1"}};
  const auto exported = write_virtualhome(home, committed_knowledge(Simulator::Virtualhome), format_facts());
  ASSERT_TRUE(exported) << format(exported.error());
  const Json json = Json::parse(exported->text);
  std::map<int, std::string> names;
  std::vector<std::string> relations;
  for (const Json& node : json["nodes"]) {
    names[node["id"]] = node["class_name"];
    if (node["class_name"] != "fridge") continue;
    EXPECT_THAT(node["properties"].get<std::vector<std::string>>(), Contains("CAN_OPEN"));
    EXPECT_THAT(node["states"].get<std::vector<std::string>>(), Contains("OPEN"));
  }
  for (const Json& edge : json["edges"]) {
    relations.push_back(names.at(edge["from_id"]) + " " + edge["relation_type"].get<std::string>() + " " +
                        names.at(edge["to_id"]));
  }
  for (const char* expected :
       {"plate INSIDE fridge", "fridge INSIDE kitchen", "fridge ON floor", "plate CLOSE fridge", "fridge CLOSE plate",
        "doorjamb BETWEEN kitchen", "doorjamb BETWEEN bedroom", "floor INSIDE kitchen", "character INSIDE kitchen"}) {
    EXPECT_THAT(relations, Contains(expected));
  }
  EXPECT_THAT(relations, Not(Contains("plate ON floor")));
  EXPECT_THAT(exported->left_out, Contains("plate_1: VirtualHome has no word for hot"));
}

TEST(Virtualhome, GroupsOfCategoriesAreUpstreams) {
  const Knowledge& knowledge = committed_knowledge(Simulator::Virtualhome);
  for (const auto& [category, group] : std::map<std::string, std::string>{{"microwave", "Appliances"},
                                                                          {"tablelamp", "Lamps"},
                                                                          {"radio", "Electronics"},
                                                                          {"plate", "Props"},
                                                                          {"sofa", "Furniture"}}) {
    ASSERT_NE(knowledge.find(category), nullptr) << category;
    EXPECT_EQ(virtualhome_group(*knowledge.find(category), knowledge), group) << category;
  }
  Category bread;
  bread.name = "bread", bread.movable = true;
  AffordanceFact sliced;
  sliced.category = "bread", sliced.affordance = "sliceable";
  EXPECT_EQ(virtualhome_group(bread, Knowledge(Simulator::Virtualhome, {bread}, {sliced}, {}, {}, {})), "Food");
}

TEST(Virtualhome, BadGraphsGetAnErrorWithItsPlace) {
  const auto with = [](const std::string& from, const std::string& to) {
    const auto scenes = read(replace_all(kFlat, from, to));
    return scenes ? std::string("accepted") : format(scenes.error());
  };
  EXPECT_EQ(with("\"id\": 4,", "\"id\": 3,"),
            "home.json#/nodes/3: schema error: the id 3 is duplicated; expected one node per id");
  EXPECT_EQ(with("[2, 0.4, 2]", "[2, 0.4]"),
            "home.json#/nodes/8/bbox_center: schema error: expected [x, y, z], not 2 items");
  EXPECT_THAT(with("[2, 0.4, 2]", "[2, NaN, 2]"), HasSubstr("home.json:11:87: parse error"));
  EXPECT_THAT(with("[2, 0.4, 2]", "[2, 1e999, 2]"), HasSubstr("parse error"));
  EXPECT_EQ(with("[1.5, 0.8, 0.9]", "[1.5, -0.8, 0.9]"),
            "home.json#/nodes/8/bbox_size: schema error: expected three lengths >= 0");
  EXPECT_EQ(with("[10, \"ON\", 9]", "[10, 9]"), "home.json#/edges/10: schema error: expected [from, relation, to]");
  EXPECT_EQ(with("\"edges\"", "\"edge\""), "home.json: schema error: the field \"edges\" is missing");
}

TEST(Virtualhome, ARoomLargerThanAnyHomeIsRefused) {
  const auto scenes = read(replace_all(kFlat, "\"bbox_center\": [5.51, 0, 1.5], \"bbox_size\": [2.98, 0, 3]",
                                       "\"bbox_center\": [5.51, 0, 1.5], \"bbox_size\": [2e9, 0, 3]"));
  ASSERT_FALSE(scenes);
  EXPECT_THAT(format(scenes.error()), HasSubstr("expected a home of at most 200 m"));
}

TEST(Virtualhome, ThingsInsideEachOtherAreListedAndThoseInNoRoomToo) {
  Json json = Json::parse(kFlat);
  json["edges"].push_back({7, "INSIDE", 8});
  json["nodes"][9]["bbox_center"] = {200, 0.85, 2};
  const auto scenes = read(json.dump());
  ASSERT_TRUE(scenes) << format(scenes.error());
  const auto imported = assemble(scenes->front(), committed_knowledge(Simulator::Virtualhome),
                                 profile_of(Simulator::Virtualhome), format_facts());
  ASSERT_TRUE(imported) << format(imported.error());
  std::vector<std::string> reasons;
  for (const ImportIssue& issue : imported->report.issues)
    reasons.push_back(std::string(name_of(issue.reason)) + " " + issue.object);
  EXPECT_THAT(reasons, Contains(HasSubstr("cyclic-containment")));
  EXPECT_THAT(reasons, Contains("outside-rooms 10"));
}

TEST(Virtualhome, AHomeOfTooManyObjectsIsRefused) {
  std::string text = "{\"edges\": [], \"nodes\": [";
  for (int i = 0; i < 30000; ++i) text += "{\"id\": " + std::to_string(i) + ", \"class_name\": \"mug\"},";
  text.back() = ']';
  const auto scenes = read(text + "}");
  ASSERT_FALSE(scenes);
  EXPECT_EQ(format(scenes.error()),
            "home.json#/nodes: schema error: 30000 objects in one home; expected at most 20000");
}

}  // namespace
}  // namespace unietp::testing
