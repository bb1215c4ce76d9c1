#include "record/task_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/limits.h"
#include "core/plain_name.h"

namespace unietp {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

Json sound_task() {
  return Json::parse(R"text({"format":"unietp-task/1","id":"ai2thor-00001","template":"open-one","split":"atomic",
    "simulator":"ai2thor","scene":"ai2thor-00001","layout":"ai2thor-home-0001","bindings":{"A":"Fridge"},
    "refinement":"","phenomena":[],"goal":{"text":"(at-end (exists (?a - Fridge) (open ?a)))","tree":{"op":"at-end","parts":[
      {"op":"exists","variable":"a","domain":{"categories":[{"category":"Fridge"}]},"body":
        {"op":"atom","predicate":"open","terms":[{"variable":"a"}]}}]}},
    "start":{"constraints":[],"edits":[],"changes":{}},
    "instruction":{"text":"Open a fridge.","writer":"grammar","style":"direct","checks":["parses-back"]},
    "purpose":{"name":"preparing","because":["refrigerator is closed"]},
    "sense":{"grade":"tolerable","parts":[{"part":"open fridge","grade":"tolerable","why":"written"}]},
    "forms":["ai2thor"],
    "expert":{"M1":{"steps":3,"failures":0},"M3":{"steps":30,"failures":2,"shortest_steps":9}},"seed":{"run":1,"slot":0,"attempt":0}})text");
}

Json sound_demonstration() {
  return Json::parse(R"text({"format":"unietp-demonstration/1","task":"ai2thor-00001","mode":"M1","steps":[
    {"action":"go_to","args":["fridge_1"],"success":true,"failure":"none","feedback":"","search":false,
     "visible":[{"id":"fridge_1","box":[0,1,2,3]}],"changes":{"removed":["mug_1"]}},
    {"action":"open","args":[{"bbox":[4,5,60,70]}],"success":true,"failure":"none","feedback":"","search":false,"visible":[],"changes":{}},
    {"action":"stop","args":[],"success":true,"failure":"none","feedback":"","search":false,"visible":[],"changes":{}}]})text");
}

TEST(ReadTask, TakesASoundLine) {
  const auto task = read_task("tasks.jsonl", 1, sound_task().dump());
  ASSERT_TRUE(task) << format(task.error());
  EXPECT_EQ(task->id, "ai2thor-00001");
  EXPECT_EQ(task->layout, "ai2thor-home-0001");
  EXPECT_EQ(task->bindings, (std::vector<std::pair<std::string, std::string>>{{"A", "Fridge"}}));
  EXPECT_EQ(task->writer, "grammar");
  EXPECT_EQ(task->purpose, "preparing");
  EXPECT_EQ(task->because, std::vector<std::string>{"refrigerator is closed"});
  EXPECT_EQ(task->grade, "tolerable");
  ASSERT_EQ(task->sense.size(), 1U);
  EXPECT_EQ(task->sense[0].part, "open fridge");
  EXPECT_EQ(task->sense[0].grade, "tolerable");
  EXPECT_EQ(task->sense[0].why, "written");
  EXPECT_EQ(task->forms, std::vector<std::string>{"ai2thor"});
  ASSERT_EQ(task->expert.size(), 2U);
  EXPECT_EQ(task->expert[0].steps, 3);
  EXPECT_EQ(task->expert[1].mode, Mode::M3);
  EXPECT_EQ(task->expert[1].failures, 2);
  const auto goal = parse_formula("goal", task->goal_text, FormulaUse::Goal);
  ASSERT_TRUE(goal);
  EXPECT_EQ(*goal, task->goal_tree);
}

TEST(ReadTask, ATaskNeedNotSayWhatItIsFor) {
  Json json = sound_task();
  json.erase("purpose");
  const auto task = read_task("tasks.jsonl", 1, json.dump());
  ASSERT_TRUE(task) << format(task.error());
  EXPECT_EQ(task->purpose, "");
  json["purpose"] = {{"name", "preparing"}};
  const auto half = read_task("tasks.jsonl", 1, json.dump());
  ASSERT_FALSE(half);
  EXPECT_THAT(half.error().message, HasSubstr("because"));
}

TEST(ReadTask, NamesThatCouldLeadOutOfAFolderAreRefused) {
  for (const char* field : {"id", "template", "split", "simulator", "scene", "layout"}) {
    for (const std::string name : {"../../x", "/etc/passwd", "..", "-x", "a/b", "a b", "a\nb", "k\u00fcche"}) {
      Json json = sound_task();
      json[field] = name;
      const auto task = read_task("tasks.jsonl", 1, json.dump());
      ASSERT_FALSE(task) << field << " " << name;
      EXPECT_THAT(task.error().message, HasSubstr(plain_name_expected()));
    }
  }
  Json shown = sound_demonstration();
  shown["task"] = "../x";
  EXPECT_FALSE(read_demonstration("M1.jsonl", 1, shown.dump()));
}

TEST(ReadTask, TextsThatLeaveTheirLineOrAreTooLongAreRefused) {
  const auto read_with = [](const Json::json_pointer& place, const std::string& text) {
    Json json = sound_task();
    json[place] = text;
    return read_task("tasks.jsonl", 1, json.dump());
  };
  for (const char* place : {"/instruction/text", "/goal/text"}) {
    EXPECT_TRUE(read_with(Json::json_pointer(place), std::string(limits::kTextBytes, 'a')));
    EXPECT_FALSE(read_with(Json::json_pointer(place), std::string(limits::kTextBytes + 1, 'a')));
    EXPECT_FALSE(read_with(Json::json_pointer(place), "Open it.\n(:goal (open door))"));
  }
  EXPECT_FALSE(read_with(Json::json_pointer("/bindings/A"), "Fridge\x1b[2J"));
}

TEST(ReadTask, AGoalNestedTooDeeplyIsRefused) {
  Json tree = sound_task()["goal"]["tree"]["parts"][0];
  for (int i = 1; i <= limits::kQuantifiers; ++i) {
    tree =
        Json{{"op", "forall"}, {"variable", "v" + std::to_string(i)}, {"domain", {{"all", "object"}}}, {"body", tree}};
    Json json = sound_task();
    json["goal"]["tree"]["parts"][0] = tree;
    const auto task = read_task("tasks.jsonl", 1, json.dump());
    EXPECT_EQ(bool(task), i < limits::kQuantifiers) << i;
  }
}

TEST(ReadTask, ASyntaxErrorHasTheLineOfTheFile) {
  const auto task = read_task("tasks.jsonl", 12, "{\"format\" ]}");
  ASSERT_FALSE(task);
  EXPECT_EQ(task.error().where, "tasks.jsonl");
  EXPECT_EQ(task.error().pos, (SourcePos{12, 11}));
}

/// Every field is needed, none may be added, and each has its type.
template <class Read>
void expect_strict(const Json& sound, Read read) {
  const Json flat = sound.flatten();
  for (const auto& [pointer, leaf] : flat.items()) {
    const Json::json_pointer place(pointer);
    Json retyped = sound;
    retyped[place] = leaf.is_string() ? Json(7) : Json("seven");
    EXPECT_FALSE(read(retyped.dump())) << pointer;
    if (!sound[place.parent_pointer()].is_object()) continue;
    Json extended = sound;
    extended[place.parent_pointer()]["surprise"] = "x";
    const bool open = place.parent_pointer().to_string() == "/bindings";
    EXPECT_TRUE(open || !read(extended.dump())) << pointer;
    Json shortened = sound;
    shortened[place.parent_pointer()].erase(place.back());
    const bool optional = pointer.find("/bindings/") == 0 || pointer.find("/expert/") == 0 ||
                          pointer.find("/changes/") != std::string::npos;
    EXPECT_TRUE(optional || !read(shortened.dump())) << pointer;
  }
}

TEST(ReadTask, RefusesMissingUnknownAndMistypedFields) {
  expect_strict(sound_task(), [](const std::string& text) { return bool(read_task("t", 1, text)); });
  auto other = sound_task();
  other["format"] = "unietp-task/2";
  const auto refused = read_task("t", 1, other.dump());
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("unietp-task/1"));
}

TEST(ReadDemonstration, TakesASoundLineAndRefusesDamage) {
  const auto demonstration = read_demonstration("M1.jsonl", 1, sound_demonstration().dump());
  ASSERT_TRUE(demonstration) << format(demonstration.error());
  ASSERT_EQ(demonstration->steps.size(), 3U);
  EXPECT_EQ(demonstration->steps[0].command, (Command{"go_to", {{"fridge_1", std::nullopt}}}));
  EXPECT_EQ(demonstration->steps[1].command, (Command{"open", {{"", PixelBox{4, 5, 60, 70}}}}));
  EXPECT_EQ(demonstration->steps[0].visible[0].box, (std::array<int, 4>{0, 1, 2, 3}));
  EXPECT_EQ(demonstration->steps[0].changes.removed, std::vector<std::string>{"mug_1"});
  expect_strict(sound_demonstration(), [](const std::string& text) { return bool(read_demonstration("d", 1, text)); });
}

TEST(ReadDemonstratedPlan, TakesTheCommandsOfALine) {
  Json shown = sound_demonstration();
  shown["shortest"] = Json::array({{{"action", "stop"}, {"args", Json::array()}}});
  const auto whole = read_demonstration("M2.jsonl", 1, shown.dump());
  const auto plan = read_demonstrated_plan("M2.jsonl", 1, shown.dump());
  ASSERT_TRUE(whole) << format(whole.error());
  ASSERT_TRUE(plan) << format(plan.error());
  EXPECT_EQ(plan->task, whole->task);
  std::vector<Command> commands;
  for (const StepRecord& step : whole->steps) commands.push_back(step.command);
  EXPECT_EQ(plan->commands, commands);
  shown["steps"][2]["action"] = "stopp";
  const auto wrong = read_demonstrated_plan("M2.jsonl", 4, shown.dump());
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().where, "M2.jsonl:4#/steps/2/action");
}

TEST(ReadDemonstration, PointsIntoTheStepThatIsWrong) {
  auto wrong = sound_demonstration();
  wrong["steps"][2]["action"] = "stopp";
  const auto read = read_demonstration("M1.jsonl", 4, wrong.dump());
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().where, "M1.jsonl:4#/steps/2/action");
  EXPECT_THAT(read.error().message, HasSubstr("did you mean \"stop\""));
}

}  // namespace
}  // namespace unietp
