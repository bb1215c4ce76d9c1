// Holds what the writers write, and what the readers accept, against data/schemas/.
#include <algorithm>
#include <set>
#include <tuple>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/limits.h"
#include "core/plain_name.h"
#include "core/text.h"
#include "random_scene.h"
#include "scene/command.h"
#include "scene/node_json.h"
#include "scene/scene_json.h"
#include "scene/schema_names.h"
#include "schema_checker.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

TEST(Schemas, EveryWrittenSceneAndDeltaFollowsItsSchemaForAnySeed) {
  SchemaChecker checker;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Scene scene = random_scene(rng);
    EXPECT_EQ(checker.check(Json::parse(scene_to_json(scene)), "scene.schema.json"), "");
    const Delta delta = difference(scene, random_successor(scene, rng));
    EXPECT_EQ(checker.check(Json::parse(delta_to_json(delta)), "delta.schema.json"), "");
  }
}

TEST(Schemas, EveryWrittenActionFollowsItsSchemaAndNoOtherName) {
  SchemaChecker checker;
  for (const auto list : {all_actions(), extension_actions()}) {
    for (const ActionInfo& action : list) {
      EXPECT_EQ(checker.check(action_to_json({action.type, {}}), "action.schema.json"), "");
    }
  }
  EXPECT_NE(checker.check(Json{{"action", "fly"}, {"args", Json::array()}}, "action.schema.json"), "");
}

TEST(Schemas, EveryWrittenCommandFollowsTheSchemaOfActionsAndReadsBack) {
  SchemaChecker checker;
  for (const Command& command : {Command{"stop", {}}, Command{"open", {{"fridge_1", std::nullopt}}},
                                 Command{"open", {{"", PixelBox{-3, 0, 400, 5}}}}}) {
    const Json json = command_to_json(command);
    EXPECT_EQ(checker.check(json, "action.schema.json"), "") << json.dump();
    const auto read = command_from_json("x", json);
    ASSERT_TRUE(read) << format(read.error());
    EXPECT_EQ(*read, command);
  }
  for (const char* bad :
       {R"({"action":"open","args":[{"bbox":[1,2,3]}]})", R"({"action":"open","args":[{"box":[1,2,3,4]}]})",
        R"({"action":"open","args":[7]})", R"({"action":"open"})", R"({"action":3,"args":[]})",
        R"({"action":"open","args":[{"bbox":[1,2,3,1e300]}]})", R"({"action":"open","args":[{"bbox":[1,2,3,0.5]}]})"}) {
    EXPECT_FALSE(command_from_json("x", Json::parse(bad))) << bad;
  }
}

TEST(Schemas, AcceptTheSameNamesAsTheReader) {
  const Json scene = schema_file("scene.schema.json");
  std::set<std::string> archetypes;
  for (const Archetype archetype : all_archetypes()) archetypes.emplace(name_of(archetype));
  const Json& node = scene["$defs"]["node"]["properties"];
  EXPECT_EQ(node["archetype"]["enum"].get<std::set<std::string>>(), archetypes);
}

TEST(Schemas, HaveTheNamesOfTheTables) {
  const auto file = read_file(std::string(UNIETP_SOURCE_DIR) + "/data/schemas/names.schema.json");
  ASSERT_TRUE(file);
  EXPECT_EQ(*file, schema_names()) << "write it anew: unietp schemas --names > data/schemas/names.schema.json";
  const Json names = Json::parse(*file)["$defs"];
  EXPECT_EQ(names["action"]["enum"].size(), kActionCount);
  EXPECT_EQ(names["relation"]["enum"].front(), "on");
  EXPECT_NE(names["state"]["pattern"].get<std::string>().find("|unplugged|"), std::string::npos);
}

TEST(Schemas, TheExampleOfThePageIsAFileAsTheWriterWritesIt) {
  const auto page = read_file(std::string(UNIETP_SOURCE_DIR) + "/docs/scenes.md");
  ASSERT_TRUE(page);
  const std::size_t start = page->find("```json\n") + 8;
  const std::string example = page->substr(start, page->find("```", start) - start);
  const auto scene = scene_from_json("docs/scenes.md", example);
  ASSERT_TRUE(scene) << format(scene.error());
  EXPECT_EQ(scene_to_json(*scene), example);
  for (const StateGroup& group : state_groups()) {
    std::string row = "| " + group.affordance + " | ";
    for (const Predicate predicate : group.predicates) {
      row += (row.back() == '`' ? ", `" : "`") + std::string(info(predicate).name) + "`";
    }
    EXPECT_NE(page->find(row + " |\n"), std::string::npos) << row;
  }
}

/// Every way to drop a field, add one or change a value's type is refused by the schema and by the reader alike.
TEST(Schemas, RefuseTheSameDamageAsTheReader) {
  SchemaChecker checker;
  Rng rng(11);
  Scene scene = random_scene(rng);
  scene.nodes = {random_node("bread_1", rng)};
  scene.nodes.edit(0).asset = "Bread_4", scene.nodes.edit(0).slice_of = "bread_0",
  scene.nodes.edit(0).whole_category = "Bread", scene.nodes.edit(0).color = "red";
  scene.nodes.edit(0).states.set({Predicate::Clean, ""});
  scene.edges = {{Predicate::On, "bread_1", "bread_1"}};
  scene.agent.held = {"bread_1"};
  const Json sound = Json::parse(scene_to_json(scene));
  ASSERT_EQ(checker.check(sound, "scene.schema.json"), "");
  int compared = 0;
  const Json flat = sound.flatten();
  for (const auto& [pointer, leaf] : flat.items()) {
    for (const Json& other : {Json(), Json("?"), Json(""), Json(true), Json(-7.5), Json::array(), Json::object()}) {
      Json damaged = sound;
      damaged[Json::json_pointer(pointer)] = other;
      const bool by_schema = checker.check(damaged, "scene.schema.json").empty();
      const auto read = scene_from_json("x", damaged.dump());
      // The reader knows more: ids that lead nowhere, the length of a quaternion, states that exclude each other.
      EXPECT_TRUE(by_schema || !read) << pointer << " " << other;
      ++compared;
    }
    Json extended = sound;
    const Json::json_pointer parent = Json::json_pointer(pointer).parent_pointer();
    if (extended[parent].is_object()) {
      extended[parent]["surprise"] = 1;
      EXPECT_NE(checker.check(extended, "scene.schema.json"), "") << pointer;
      EXPECT_FALSE(scene_from_json("x", extended.dump())) << pointer;
      Json shortened = sound;
      shortened[parent].erase(Json::json_pointer(pointer).back());
      EXPECT_EQ(checker.check(shortened, "scene.schema.json").empty(), bool(scene_from_json("x", shortened.dump())))
          << pointer;
    }
  }
  EXPECT_GT(compared, 300);
}

TEST(Schemas, StateTheBoundsOfTheReaders) {
  const std::string kScene = "scene.schema.json", kTask = "task.schema.json", kRun = "run.schema.json";
  const std::string kNode = "/$defs/node/properties";
  const std::tuple<std::string, std::string, double> kBounds[] = {
      {kScene, "/$defs/plain_name/maxLength", limits::kNameBytes},
      {kScene, "/$defs/id/maxLength", limits::kLabelBytes},
      {kScene, kNode + "/category/maxLength", limits::kLabelBytes},
      {kScene, kNode + "/colour/maxLength", limits::kLabelBytes},
      {kScene, "/$defs/edge/properties/from/maxLength", limits::kLabelBytes},
      {kScene, "/$defs/room/properties/type/maxLength", limits::kLabelBytes},
      {kScene, "/$defs/room/properties/polygon/maxItems", limits::kRoomCorners},
      {kScene, "/$defs/vec2/items/maximum", limits::kPosition_m},
      {kScene, "/$defs/vec2/items/minimum", -limits::kPosition_m},
      {kScene, "/$defs/vec3/items/maximum", limits::kPosition_m},
      {kScene, "/$defs/opening/properties/height/maximum", limits::kWallHeight_m},
      {kScene, kNode + "/size/items/maximum", limits::kObject_m},
      {kScene, kNode + "/boards/maxItems", limits::kObjectBoards},
      {kScene, kNode + "/boards/items/properties/size/items/maximum", limits::kObject_m},
      {kScene, "/properties/wall_height/maximum", limits::kWallHeight_m},
      {kScene, "/properties/wall_thickness/maximum", limits::kWallThickness_m},
      {kScene, "/properties/rooms/maxItems", limits::kRooms},
      {kScene, "/properties/openings/maxItems", limits::kOpenings},
      {kScene, "/properties/nodes/maxItems", limits::kObjects},
      {kScene, "/properties/edges/maxItems", limits::kEdges},
      {kTask, "/properties/goal/properties/text/maxLength", limits::kTextBytes},
      {kTask, "/properties/instruction/properties/text/maxLength", limits::kTextBytes},
      {kTask, "/properties/seed/properties/run/maximum", double{limits::kSeed}},
      {kRun, "/properties/seed/maximum", double{limits::kSeed}},
      {kRun, "/properties/count/maximum", limits::kTasks},
      {kRun, "/properties/attempts/maximum", limits::kAttempts},
  };
  for (const auto& [file, place, bound] : kBounds)
    EXPECT_EQ(schema_file(file).at(Json::json_pointer(place)).get<double>(), bound) << file << place;
}

TEST(Schemas, NamesOfFilesHaveTheGrammarOfTheReaders) {
  SchemaChecker checker;
  const auto in_schema = [&](const std::string& name) {
    auto task = Json{{"format", "unietp-review-mark/1"}, {"task", name}, {"verdict", "accept"}, {"comment", ""}};
    return checker.check(task, "review-mark.schema.json").empty();
  };
  for (int sign = 1; sign < 128; ++sign) {
    for (const std::string& name :
         {std::string(1, static_cast<char>(sign)), "a" + std::string(1, static_cast<char>(sign))})
      EXPECT_EQ(in_schema(name), is_plain_name(name)) << sign;
  }
  for (const std::size_t size : {std::size_t{0}, limits::kNameBytes, limits::kNameBytes + 1}) {
    const std::string name(size, 'a');
    EXPECT_EQ(in_schema(name), is_plain_name(name)) << size;
  }
}

}  // namespace
}  // namespace unietp
