// Tasks in houses of ProcTHOR as files for AI2-THOR, read by code of the tests.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "core/files.h"
#include "data_set.h"
#include "exports/own_scene.h"
#include "program.h"
#include "schema_checker.h"
#include "tests/exports/ltlf_reader.h"
#include "tests/support/committed_knowledge.h"

namespace unietp::testing {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json json_of(const fs::path& file) {
  const auto text = read_maybe_gzip(file);
  EXPECT_TRUE(text) << file;
  return Json::parse(text ? *text : "null");
}

/// Tasks of AI2-THOR in two imported houses, exported; and a few of generated homes.
class ExportAi2thor : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new ScratchFolder;
    const auto houses = fs::path(UNIETP_SOURCE_DIR) / "tests" / "end_to_end" / "homes" / "houses.procthor.jsonl";
    must({"scene", "import", "auto", houses.string(), "--out", folder_->at("homes")});
    must({"generate", "--count", "16", "--seed", "9", "--simulators", "ai2thor", "--scenes", folder_->at("homes"),
          "--modes", "M1", "--out", folder_->at("tasks")});
    must({"export", folder_->at("tasks"), "--format", "ai2thor", "--out", folder_->at("out")});
    must({"export", small_data_set().string(), "--format", "ai2thor", "--out", folder_->at("small")});
  }
  static void TearDownTestSuite() { delete folder_; }
  static void must(const std::vector<std::string>& arguments) {
    const auto ended = run_program(arguments);
    ASSERT_EQ(ended.code, 0) << ended.err;
  }
  /// Names of the tasks in a folder of the export.
  static std::vector<std::string> tasks_in(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) {
      const std::string name = entry.path().filename();
      if (name.ends_with(".json") && !name.ends_with(".house.json")) names.insert(entry.path().stem());
    }
    return {names.begin(), names.end()};
  }
  /// Both exports.
  static std::vector<fs::path> folders() { return {folder_->at("out"), folder_->at("small")}; }
  static ScratchFolder* folder_;
};
ScratchFolder* ExportAi2thor::folder_ = nullptr;

void collect_ids(const Json& objects, std::set<std::string>& ids) {
  for (const auto& one : objects) {
    EXPECT_TRUE(ids.insert(one["id"]).second) << one["id"];
    if (one.contains("children")) collect_ids(one["children"], ids);
  }
}

/// All values of these keys, anywhere.
void collect_values(const Json& json, const std::set<std::string>& keys, std::vector<std::string>& values) {
  if (json.is_object()) {
    for (const auto& [key, value] : json.items()) {
      if (keys.contains(key)) values.push_back(value);
    }
  }
  if (json.is_structured()) {
    for (const auto& inner : json) collect_values(inner, keys, values);
  }
}

bool inside(double x, double z, const Json& polygon) {
  bool is_inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const double ax = polygon[i]["x"], az = polygon[i]["z"], bx = polygon[j]["x"], bz = polygon[j]["z"];
    if ((az > z) != (bz > z) && x < (bx - ax) * (z - az) / (bz - az) + ax) is_inside = !is_inside;
  }
  return is_inside;
}

TEST_F(ExportAi2thor, EveryTaskIsWrittenOrLeftOutWithAReason) {
  SchemaChecker checker;
  for (const auto& out : folders()) {
    const auto tasks =
        json_lines((out == folder_->at("out") ? fs::path(folder_->at("tasks")) : small_data_set()) / "tasks.jsonl");
    const auto left_out = json_lines(out / "left_out.jsonl");
    EXPECT_EQ(tasks_in(out).size() + left_out.size(), tasks.size());
    for (const auto& line : left_out) EXPECT_EQ(checker.check(line, "left_out.schema.json"), "");
    for (const auto& task : tasks_in(out))
      EXPECT_EQ(checker.check(json_of(out / (task + ".json")), "ai2thor.schema.json"), "") << task;
  }
  EXPECT_GE(tasks_in(folder_->at("out")).size(), 12U) << "in houses of its own";
}

void expect_listed(const Json& place, const Knowledge& knowledge, std::size_t& pairs) {
  for (const auto& thing : place.value("children", Json::array())) {
    const std::string kind = thing["objectType"], in_or_on = place["objectType"];
    EXPECT_TRUE(listed_in_ai2thor(knowledge, kind, in_or_on)) << kind << " in or on " << in_or_on;
    ++pairs;
    expect_listed(thing, knowledge, pairs);
  }
}

TEST_F(ExportAi2thor, InHomesOfOursThingsAreWhereAi2thorsTablesHaveThem) {
  const Knowledge& knowledge = committed_knowledge(Simulator::Ai2thor);
  std::size_t pairs = 0;
  for (const auto& task : tasks_in(folder_->at("small"))) {
    SCOPED_TRACE(task);
    const Json house = json_of(fs::path(folder_->at("small")) / (task + ".house.json"));
    for (const auto& thing : house["objects"]) expect_listed(thing, knowledge, pairs);
  }
  EXPECT_GT(pairs, 50U);
}

TEST_F(ExportAi2thor, EveryObjectThatACallOrATestNamesIsInTheHouse) {
  std::size_t named = 0;
  for (const auto& out : folders()) {
    for (const auto& task : tasks_in(out)) {
      SCOPED_TRACE(task);
      std::set<std::string> ids;
      collect_ids(json_of(out / (task + ".house.json"))["objects"], ids);
      std::vector<std::string> values;
      collect_values(json_of(out / (task + ".json")), {"objectId", "near", "contains"}, values);
      for (const std::string& value : values) {
        const auto piece = value.rfind('|');  // Bread|2|1|BreadSliced_0
        EXPECT_TRUE(ids.contains(value) || ids.contains(value.substr(0, piece))) << value;
        ++named;
      }
    }
  }
  EXPECT_GT(named, 50U);
}

TEST_F(ExportAi2thor, TheAgentStandsInARoom) {
  std::size_t poses = 0;
  for (const auto& out : folders()) {
    for (const auto& task : tasks_in(out)) {
      SCOPED_TRACE(task);
      const Json house = json_of(out / (task + ".house.json"));
      const Json json = json_of(out / (task + ".json"));
      for (const auto& step : json["plan"]) {
        for (const auto& call : step["calls"]) {
          if (!call.contains("position")) continue;
          const double x = call["position"]["x"], z = call["position"]["z"];
          EXPECT_TRUE(std::any_of(house["rooms"].begin(), house["rooms"].end(), [&](const Json& room) {
            return inside(x, z, room["floorPolygon"]);
          })) << call;
          ++poses;
        }
      }
    }
  }
  EXPECT_GT(poses, 20U);
}

TEST_F(ExportAi2thor, TheGoalHoldsAtTheEndOfTheDemonstrationAndNotAtItsStart) {
  for (const auto& out : folders()) {
    for (const auto& task : tasks_in(out)) {
      SCOPED_TRACE(task);
      const Json json = json_of(out / (task + ".json"));
      std::set<std::string> known;
      for (const auto& one : json["goal"]["propositions"]) known.insert(one["name"]);
      LtlfTrace trace;
      const auto add = [&](const Json& holds) {
        trace.emplace_back();
        for (const auto& name : holds) {
          EXPECT_TRUE(known.contains(name));
          trace.back().insert(name.get<std::string>());
        }
      };
      add(json["goal"]["holds"]);
      EXPECT_FALSE(ltlf_holds(json["goal"]["formula"], trace));
      for (const auto& step : json["plan"]) {
        for (const auto& moment : step.contains("moments") ? step["moments"] : Json::array({step["holds"]}))
          add(moment);
      }
      EXPECT_TRUE(ltlf_holds(json["goal"]["formula"], trace));
    }
  }
}

/// Composite actions show in the plan each moment that the demonstration passes through, with what holds then: the same
/// of each proposition that the format `ltlf` has under the same name.
TEST_F(ExportAi2thor, EachMomentOfACompositeActionIsInThePlan) {
  std::size_t composite = 0, compared = 0;
  for (const auto& [tasks, out] : {std::pair(small_data_set(), folder_->at("small")),
                                   std::pair(fs::path(folder_->at("tasks")), folder_->at("out"))}) {
    const std::string ltlf = out + "-ltlf";
    must({"export", tasks.string(), "--format", "ltlf", "--out", ltlf});
    std::map<std::string, Json> shown, in_ltlf;
    for (auto& line : json_lines(tasks / "demonstrations" / "M1.jsonl")) shown[line["task"]] = line["steps"];
    for (auto& line : json_lines(fs::path(ltlf) / "goals.jsonl")) in_ltlf[line["task"]] = line;
    for (const auto& task : tasks_in(out)) {
      SCOPED_TRACE(task);
      const Json json = json_of(fs::path(out) / (task + ".json"));
      std::vector<std::set<std::string>> held{json["goal"]["holds"]};
      for (std::size_t i = 0; i < json["plan"].size(); ++i) {
        const Json &step = json["plan"][i], &recorded = shown[task][i];
        const Json moments = step.value("moments", Json::array({step["holds"]}));
        ASSERT_EQ(moments.size(), recorded.contains("moments") ? recorded["moments"].size() : 1U);
        EXPECT_EQ(moments.back(), step["holds"]);
        composite += recorded.contains("moments") ? 1 : 0;
        for (const auto& moment : moments) held.push_back(moment);
      }
      if (!in_ltlf.contains(task)) continue;
      std::set<std::string> ours;
      for (const auto& one : json["goal"]["propositions"]) ours.insert(one["name"]);
      const Json& trace = in_ltlf[task]["traces"]["M1"];
      ASSERT_GE(trace.size(), held.size());  // `stop` is a step there
      for (std::size_t i = 0; i < held.size(); ++i) {
        const std::set<std::string> theirs = trace[i];
        for (const auto& one : in_ltlf[task]["propositions"]) {
          const std::string name = one["name"];
          if (!ours.contains(name)) continue;
          EXPECT_EQ(held[i].contains(name), theirs.contains(name)) << name << " at moment " << i;
          ++compared;
        }
      }
    }
  }
  EXPECT_GT(composite, 0U);
  EXPECT_GT(compared, 0U);
}

TEST_F(ExportAi2thor, GivesTheSameBytesAgain) {
  must({"export", folder_->at("tasks"), "--format", "ai2thor", "--out", folder_->at("again")});
  EXPECT_EQ(bytes_below(folder_->at("again")), bytes_below(folder_->at("out")));
}

}  // namespace
}  // namespace unietp::testing
