#include "scene/scene_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/limits.h"
#include "core/text.h"
#include "random_scene.h"
#include "scene/json_parse.h"

namespace unietp {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using Json = nlohmann::ordered_json;

Scene small_scene() {
  Scene scene;
  scene.id = "home";
  scene.rooms.push_back({"kitchen_1", "kitchen", {{0, 0}, {4, 0}, {4, 3}, {0, 3}}});
  scene.rooms.push_back({"hall_1", "corridor", {{4, 0}, {6, 0}, {6, 3}, {4, 3}}});
  scene.openings.push_back({"opening_1", "kitchen_1", "hall_1", {4, 1}, {4, 1.9}, 2});
  for (const char* id : {"mug_1", "sink_1"}) {
    Node node;
    node.id = id, node.category = "Thing", node.size = {0.1, 0.1, 0.1};
    scene.nodes.push_back(node);
  }
  scene.nodes.edit(0).states.set({Predicate::Filled, "water"});
  scene.edges = {{Predicate::Inside, "mug_1", "sink_1"}, {Predicate::InRoom, "agent", "kitchen_1"}};
  return scene;
}

/// The error of the small scene with one piece of its text replaced.
Error error_with(const std::string& from, const std::string& to) {
  const std::string text = scene_to_json(small_scene());
  EXPECT_NE(text.find(from), std::string::npos) << from << " is not in\n" << text;
  const auto read = scene_from_json("home.json", replace_all(text, from, to));
  EXPECT_FALSE(read) << to << " was accepted";
  return read ? Error{} : read.error();
}

TEST(SceneJson, ReadsBackTheSameSceneToTheSameBytesForAnySeed) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Scene scene = random_scene(rng);
    const std::string text = scene_to_json(scene);
    const auto read = scene_from_json("x", text);
    ASSERT_TRUE(read) << format(read.error());
    EXPECT_EQ(*read, scene);
    EXPECT_EQ(scene_to_json(*read), text);
  }
}

TEST(SceneJson, KeepsEveryBitOfANumber) {
  Scene scene = small_scene();
  for (const double value :
       {-0.0, 0.1 + 0.2, std::nextafter(1.0, 2.0), 5e-324, 1.7976931348623157e308, -1e22, 123456789.0}) {
    scene.agent.yaw = value;
    const double coordinate = std::abs(value) < limits::kPosition_m ? value : 0;
    scene.nodes.edit(0).pose.position.x() = coordinate;
    const auto read = scene_from_json("x", scene_to_json(scene));
    ASSERT_TRUE(read) << format(read.error());
    EXPECT_EQ(std::signbit(read->agent.yaw), std::signbit(value));
    EXPECT_EQ(read->agent.yaw, value);
    EXPECT_EQ(read->nodes[0].pose.position.x(), coordinate);
  }
}

TEST(SceneJson, AcceptsFieldsAndEdgesInAnyOrderAndWholeNumbers) {
  Json json = Json::parse(scene_to_json(small_scene()));
  Json turned = Json::object();
  for (auto field = json.rbegin(); field != json.rend(); ++field) turned[field.key()] = field.value();
  std::reverse(turned["edges"].begin(), turned["edges"].end());
  turned["nodes"][0]["mass"] = 0;
  turned["rooms"][0]["polygon"] = Json::parse("[[0,0],[4,0],[4,3],[0,3]]");
  const auto read = scene_from_json("x", turned.dump());
  ASSERT_TRUE(read) << format(read.error());
  EXPECT_EQ(*read, small_scene());
}

TEST(SceneJson, ReportsLineAndColumnOfTheFirstBadByte) {
  const auto read = scene_from_json("home.json", "{\n  \"format\" \"x\"\n}");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().kind, Error::Kind::Parse);
  EXPECT_EQ(read.error().where, "home.json");
  EXPECT_EQ(read.error().pos.line, 2);
  EXPECT_THAT(read.error().message, HasSubstr("expected ':'"));
  const auto empty = scene_from_json("home.json", "");
  ASSERT_FALSE(empty);
  EXPECT_EQ(empty.error().pos, (SourcePos{1, 1}));
  const auto huge = scene_from_json("home.json", "\n [1e999]");
  ASSERT_FALSE(huge);
  EXPECT_EQ(huge.error().pos.line, 2);
  EXPECT_EQ(error_with("\"id\": \"home\"", "\"id\": \"\xff\"").kind, Error::Kind::Parse);
  EXPECT_EQ(error_with("\"id\": \"home\"", "\"id\": NaN").kind, Error::Kind::Parse);
}

TEST(SceneJson, PointsAtWhatBreaksTheSchema) {
  const struct {
    std::string from, to, pointer, message;
  } cases[] = {
      {"\"wall_height\": 2.6,", "", "", "the field \"wall_height\" is missing"},
      {"\"wall_height\"", "\"wall_hight\"", "", "the field \"wall_height\" is missing"},
      {"\"id\": \"home\"", "\"id\": \"home\", \"colour\": 1", "#/colour", "unknown field \"colour\""},
      {"\"mass\":", "\"colours\":1,\"mass\":", "#/nodes/0/colours", "did you mean \"colour\""},
      {"\"mass\":0.0", "\"mass\":\"0\"", "#/nodes/0/mass", "expected a number, not a JSON string"},
      {"\"mass\":0.0", "\"mass\":-1", "#/nodes/0/mass", "0 or more, not -1"},
      {"\"size\":[0.1,0.1,0.1]", "\"size\":[0.1,0,0.1]", "#/nodes/0/size", "three lengths above 0"},
      {"\"size\":[0.1,0.1,0.1]", "\"size\":[0.1,0.1]", "#/nodes/0/size", "expected [x, y, z], not 2 items"},
      {"\"size\":[0.1,0.1,0.1]", "\"size\":[0.1,0.1,null]", "#/nodes/0/size/2", "not null"},
      {"\"rotation\":[1.0,", "\"rotation\":[1.1,", "#/nodes/0/rotation", "length 1"},
      {"\"opening\":0.0", "\"opening\":1.01", "#/nodes/0/opening", "0 to 1"},
      {"\"movable\":false", "\"movable\":0", "#/nodes/0/movable", "true or false"},
      {"\"archetype\":\"box\"", "\"archetype\":\"boxx\"", "#/nodes/0/archetype",
       "did you mean \"box\"; accepted are block,"},
      {"\"simulator\": \"ai2thor\"", "\"simulator\": \"gazebo\"", "#/simulator",
       "accepted are ai2thor, virtualhome, habitat, behavior"},
      {"filled(water)", "filed(water)", "#/nodes/0/states/0", "unknown state"},
      {"filled(water)", "filled", "#/nodes/0/states/0", "expected \"filled(symbol)\""},
      {"filled(water)", "filled()", "#/nodes/0/states/0", "expected \"filled(symbol)\""},
      {"filled(water)", "clean(water)", "#/nodes/0/states/0", "expected \"clean\""},
      {"filled(water)", "held", "#/nodes/0/states/0", "unknown state"},
      {"\"filled(water)\"", "\"open\",\"closed\"", "#/nodes/0/states/1", "excludes one before"},
      {"\"filled(water)\"", "\"open\",\"open\"", "#/nodes/0/states/1", "repeats"},
      {"\"id\":\"sink_1\"", "\"id\":\"mug_1\"", "#/nodes/1/id", "the id \"mug_1\" is taken"},
      {"\"id\":\"sink_1\"", "\"id\":\"hall_1\"", "#/nodes/1/id", "taken"},
      {"\"id\":\"sink_1\"", "\"id\":\"agent\"", "#/nodes/1/id", "taken"},
      {"\"id\":\"sink_1\"", "\"id\":\"sink_2\"", "#/edges/0/to", "no object \"sink_1\""},
      {"\"from\":\"agent\"", "\"from\":\"me\"", "#/edges/1/from", "no object \"me\""},
      {"\"to\":\"kitchen_1\"", "\"to\":\"mug_1\"", "#/edges/1/to", "no room \"mug_1\""},
      {"\"relation\":\"inside\"", "\"relation\":\"nearest\"", "#/edges/0/relation", "unknown relation"},
      {"\"room_b\":\"hall_1\"", "\"room_b\":\"mug_1\"", "#/openings/0/room_b", "no room \"mug_1\""},
      {"\"held\":[]", "\"held\":[\"cup_9\"]", "#/agent/held/0", "no object \"cup_9\""},
      {"\"held\":[]", "\"held\":[\"mug_1\",\"mug_1\"]", "#/agent/held/1", "twice"},
      {"[[0.0,0.0],[4.0,0.0],[4.0,3.0],[0.0,3.0]]", "[[0,0],[4,0]]", "#/rooms/0/polygon", "three corners"},
      {"unietp-scene/1", "unietp-scene/2", "#/format", "expected the format \"unietp-scene/1\""},
      {"\"category\":\"Thing\"", "\"category\":\"\"", "#/nodes/0/category", "not empty"},
      {"\"category\":\"Thing\"", "\"category\":\"Thing\",\"category\":\"Thing\"", "#/nodes/0", "occurs twice"},
      {"\"wall_height\": 2.6", "\"wall_height\": 0", "#/wall_height", "above 0"},
  };
  for (const auto& [from, to, pointer, message] : cases) {
    SCOPED_TRACE(to);
    const Error error = error_with(from, to);
    EXPECT_EQ(error.kind, Error::Kind::Schema);
    EXPECT_EQ(error.where, "home.json" + pointer);
    EXPECT_THAT(error.message, HasSubstr(message));
  }
}

TEST(SceneJson, RefusesAnEdgeThatStandsTwice) {
  std::string text = scene_to_json(small_scene());
  const auto from = text.find('\n', text.find("\"edges\"")) + 1;  // one edge a line
  const auto line = text.substr(from, text.find('}', from) + 1 - from);
  const auto read = scene_from_json("x", text.insert(from, line + ",\n"));
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().where, "x#/edges");
}

TEST(SceneJson, RefusesDeepAndWideInputWithoutSpendingMuchOnIt) {
  for (const std::string& open : {std::string("["), std::string("{\"a\":")}) {
    std::string text;
    for (int i = 0; i < 200000; ++i) text += open;
    const auto read = scene_from_json("x", text);
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().message, StartsWith("nested deeper"));
  }
  std::string wide = "{";
  for (int i = 0; i < 200000; ++i) wide += "\"k" + std::to_string(i) + "\":0,";
  const auto read = scene_from_json("x", wide);
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message, StartsWith("more than 64 fields"));
}

TEST(ParseJson, ReadsWideObjectsWhereTheCallerAllowsAndStillFindsARepeatedField) {
  constexpr std::size_t kWide = 200000;
  std::string wide = "{\"a\":{";
  for (std::size_t i = 0; i < kWide; ++i) wide += "\"k" + std::to_string(i) + "\":{\"k0\":[{\"k0\":1}]},";
  const auto read = parse_json("x", wide + "\"last\":2},\"k0\":3}", kWide + 1);
  ASSERT_TRUE(read) << format(read.error());
  EXPECT_EQ((*read)["a"].size(), kWide + 1);
  const auto repeated = parse_json("x", wide + "\"k77\":2}}", kWide + 1);
  ASSERT_FALSE(repeated);
  EXPECT_EQ(format(repeated.error()), "x#/a: schema error: the field \"k77\" occurs twice in one object");
  const auto wider = parse_json("x", wide + "\"last\":2}}", kWide);
  ASSERT_FALSE(wider);
  EXPECT_THAT(wider.error().message, StartsWith("more than 200000 fields"));
}

TEST(ParseJson, LeavesFieldsOutInEveryObjectAndReadsOnBehindThem) {
  const std::array<std::string_view, 2> names{"big", "gone"};
  const auto read = parse_json_without(
      names, "x",
      R"({"a":[{"big":{"a":[1,{"gone":2}]},"b":1},{"gone":[],"big":"a"}],"gone":null,"c":"big","d":{"big":true}})");
  ASSERT_TRUE(read) << format(read.error());
  EXPECT_EQ(read->dump(), R"({"a":[{"b":1},{}],"c":"big","d":{}})");
  EXPECT_FALSE(parse_json_without(names, "x", R"({"a":1,"big":[1,}})"));
  EXPECT_FALSE(parse_json_without(names, "x", R"({"a":1,"gone":[],"a":2})"));
}

TEST(ParseJson, CountsEveryValueOfAText) {
  // The outer list is a value, too.
  const auto list_of = [](std::size_t count, std::string_view value) {
    std::string text = "[";
    for (std::size_t i = 0; i < count; ++i) (i == 0 ? text : text += ',') += value;
    return text + "]";
  };
  EXPECT_TRUE(parse_json("x", list_of(limits::kJsonValues - 1, "1")));
  for (const char* value : {"1", "[]", "\"\"", "null"}) {
    const auto more = parse_json("x", list_of(limits::kJsonValues, value));
    EXPECT_EQ(more ? "" : more.error().message, "has more than 4000000 JSON values, the most that is read") << value;
  }
}

TEST(SceneJson, NeitherThrowsNorCrashesOnDamagedTextForAnySeed) {
  Rng scenes(7);
  const std::string sound = scene_to_json(random_scene(scenes));
  const std::string alphabet = "{}[]\",:0eE-+.ntf \\/\xc3\xa9\x01(u";
  int refused = 0;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    Rng rng(seed);
    std::string text = rng.chance(0.2) ? sound.substr(0, rng.below(sound.size())) : sound;
    for (std::uint64_t i = 1 + rng.below(4); i > 0 && !text.empty(); --i) {
      const std::size_t place = rng.below(text.size());
      if (rng.chance(0.5)) {
        text[place] = alphabet[rng.below(alphabet.size())];
      } else {
        text.erase(place, 1 + rng.below(30));
      }
    }
    if (const auto read = scene_from_json("x", text); !read) {
      ++refused;
      EXPECT_FALSE(read.error().message.empty());
      EXPECT_TRUE(read.error().kind == Error::Kind::Schema || read.error().pos.line > 0) << format(read.error());
    }
  }
  EXPECT_GT(refused, 2000);
}

TEST(DeltaJson, ReadsBackTheSameForAnySeed) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Scene before = random_scene(rng);
    const Delta delta = difference(before, random_successor(before, rng));
    const auto text = delta_to_json(delta);
    const auto read = delta_from_json("x", Json::parse(text));
    ASSERT_TRUE(read) << format(read.error());
    EXPECT_EQ(*read, delta);
    EXPECT_EQ(delta_to_json(*read), text);
  }
  EXPECT_EQ(delta_to_json({}), "{}");
}

TEST(DeltaJson, RefusesWhatContradictsItself) {
  const auto error_of = [](const char* text) {
    const auto read = delta_from_json("d", Json::parse(text));
    EXPECT_FALSE(read);
    return read ? std::string() : format(read.error());
  };
  EXPECT_THAT(error_of(R"({"removed":["a","a"]})"), StartsWith("d#/removed/1"));
  EXPECT_THAT(error_of(R"({"gone":["a"]})"), StartsWith("d#/gone"));
  EXPECT_THAT(error_of(R"([])"), HasSubstr("expected an object"));
  Json json = Json::object();
  json["agent"] = {{"position", {0, 0}}, {"yaw_rad", std::numeric_limits<double>::quiet_NaN()}};
  const auto read = delta_from_json("d", json);
  ASSERT_FALSE(read);
  EXPECT_EQ(format(read.error()), "d#/agent/yaw_rad: schema error: expected a finite number");
}

TEST(ActionJson, ReadsBackEveryAction) {
  for (const auto list : {all_actions(), extension_actions()}) {
    for (const ActionInfo& known : list) {
      Action action{known.type, {}};
      if (known.argument != ActionArgument::None) action.args = {"sink_1"};
      const auto read = action_from_json("x", action_to_json(action));
      ASSERT_TRUE(read) << format(read.error());
      EXPECT_EQ(*read, action);
    }
  }
  EXPECT_EQ(action_to_json({ActionType::PlaceIn, {"sink_1"}}).dump(), R"({"action":"place_in","args":["sink_1"]})");
}

TEST(ActionJson, SaysWhatIsWrongWithAnAction) {
  const auto error_of = [](const char* text) {
    const auto read = action_from_json("a", Json::parse(text));
    EXPECT_FALSE(read);
    return read ? std::string() : format(read.error());
  };
  EXPECT_THAT(error_of(R"({"action":"pickup","args":["a"]})"), HasSubstr("did you mean \"pick_up\""));
  EXPECT_THAT(error_of(R"({"action":"pick_up","args":[]})"), HasSubstr("a#/args: schema error: pick_up takes one"));
  EXPECT_THAT(error_of(R"({"action":"drop","args":["a"]})"), HasSubstr("drop takes no argument"));
  EXPECT_THAT(error_of(R"({"action":"pick_up","args":[{"bbox":[0,0,1,1]}]})"), HasSubstr("a#/args/0"));
  EXPECT_THAT(error_of(R"({"action":3,"args":[]})"), HasSubstr("a#/action"));
  EXPECT_THAT(error_of(R"("stop")"), HasSubstr("expected an object"));
}

}  // namespace
}  // namespace unietp
