// A data set in all three modes: every demonstration is proven under the rules of its mode, from what the agent said
// alone, and what breaks them is found.
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/digest.h"
#include "core/files.h"
#include "core/text.h"
#include "data_set.h"
#include "schema_checker.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

constexpr int kCount = kCountInAllModes;

const fs::path& in_all_modes() { return data_set_in_all_modes(); }

std::string file_of(const std::string& mode) { return "demonstrations/" + mode + ".jsonl"; }

/// A copy in which the demonstrations of one mode are changed, with true checksums.
class Changed {
 public:
  Changed() : folder_(scratch_.at("copy")) { fs::copy(in_all_modes(), folder_, fs::copy_options::recursive); }

  template <class Change>
  void each(const std::string& mode, Change change) {
    std::string text;
    for (Json json : json_lines(folder_ / file_of(mode))) {
      change(json);
      text += json.dump() + "\n";
    }
    EXPECT_TRUE(write_file(folder_ / file_of(mode), text));
    auto manifest = Json::parse(*read_file(folder_ / "manifest.json"));
    for (auto& file : manifest["files"]) {
      const auto bytes = read_file(folder_ / file["path"].get<std::string>());
      ASSERT_TRUE(bytes);
      file["bytes"] = bytes->size();
      file["sha256"] = sha256(*bytes);
    }
    EXPECT_TRUE(write_file(folder_ / "manifest.json", manifest.dump(2) + "\n"));
  }
  /// No task is proven any more, each for a reason that holds the words.
  void expect_all_wrong(const std::string& words) const {
    const auto verdict = validate(folder_);
    EXPECT_EQ(verdict.code, 1);
    EXPECT_EQ(verdict.proven, 0);
    for (const auto& task : json_lines(folder_ / "tasks.jsonl")) {
      std::string told;
      for (const auto& problem : verdict.problems) {
        if (problem.task == task["id"]) told += problem.message + "\n";
      }
      EXPECT_THAT(told, HasSubstr(words)) << task["id"];
    }
  }

 private:
  ScratchFolder scratch_;
  fs::path folder_;
};

TEST(Modes, EachTaskIsShownInAllThreeAndProven) {
  const auto verdict = validate(in_all_modes());
  EXPECT_EQ(verdict.code, 0);
  EXPECT_EQ(verdict.proven, kCount);
  SchemaChecker checker;
  const auto manifest = Json::parse(*read_file(in_all_modes() / "manifest.json"));
  EXPECT_EQ(checker.check(manifest, "manifest.schema.json"), "");
  EXPECT_EQ(manifest["configuration"]["modes"], (Json{"M1", "M2", "M3"}));
  const auto tasks = json_lines(in_all_modes() / "tasks.jsonl");
  ASSERT_EQ(tasks.size(), static_cast<std::size_t>(kCount));
  for (const std::string mode : {"M1", "M2", "M3"}) {
    const auto lines = json_lines(in_all_modes() / file_of(mode));
    ASSERT_EQ(lines.size(), tasks.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
      EXPECT_EQ(checker.check(lines[i], "demonstration.schema.json"), "");
      EXPECT_EQ(lines[i]["task"], tasks[i]["id"]);
      EXPECT_EQ(lines[i]["mode"], mode);
      EXPECT_EQ(tasks[i]["expert"][mode]["steps"], lines[i]["steps"].size());
      EXPECT_EQ(checker.check(tasks[i], "task.schema.json"), "");
    }
  }
}

TEST(Modes, FewCandidatesAreGivenUpForThem) {
  int in_m2 = 0, in_m3 = 0;
  for (const auto& rejection : json_lines(in_all_modes() / "rejections.jsonl")) {
    in_m2 += rejection["reason"] == "not-in-m2" ? 1 : 0;  // mostly what was not found within 50 steps
    in_m3 += rejection["reason"] == "not-in-m3" ? 1 : 0;  // of those that M2 can show
  }
  EXPECT_LE(in_m2, kCount / 4);
  EXPECT_LE(in_m3, kCount / 4);  // one in seven of a benchmark
}

TEST(Modes, SomeDemonstrationsOfM2AndMostOfM3SearchAndNoneOfM1) {
  const auto searching = [](const std::string& mode) {
    int count = 0;
    for (const auto& line : json_lines(in_all_modes() / file_of(mode))) {
      const auto& steps = line["steps"];
      count += std::any_of(steps.begin(), steps.end(), [](const Json& step) { return step["search"].get<bool>(); });
    }
    return count;
  };
  EXPECT_GT(searching("M2"), kCount / 4);
  EXPECT_GT(searching("M3"), kCount / 2);
  EXPECT_EQ(searching("M1"), 0);
}

TEST(Modes, AMarkOfSearchThatIsTurnedRoundIsFound) {
  Changed copy;
  copy.each("M2", [](Json& line) {
    auto& mark = line["steps"][0]["search"];
    mark = !mark.get<bool>();
  });
  copy.expect_all_wrong("search");
}

TEST(Modes, ALongerShortestPlanIsFound) {
  Changed copy;
  copy.each("M2", [](Json& line) {
    const Json first = line["shortest"][0];
    line["shortest"].insert(line["shortest"].begin(), first);
  });
  copy.expect_all_wrong("its shortest plan");
}

TEST(Modes, OnlyM3PointsAtThingsWithBoxes) {
  for (const std::string mode : {"M1", "M2", "M3"}) {
    for (const auto& line : json_lines(in_all_modes() / file_of(mode))) {
      for (const auto& step : line["steps"]) {
        for (const auto& argument : step["args"]) {
          const bool may_be_room = step["action"] == "go_to" && argument.is_string();
          EXPECT_TRUE(mode == "M3" ? argument.is_object() || may_be_room : argument.is_string()) << step["action"];
        }
      }
    }
  }
}

TEST(Modes, AnIdInM3IsRefused) {
  Changed copy;
  copy.each("M3", [](Json& line) {
    for (auto& step : line["steps"]) {
      for (auto& argument : step["args"]) {
        if (argument.is_object()) argument = "thing_1";
      }
    }
  });
  copy.expect_all_wrong("In M3 objects are named by boxes in the picture.");
}

TEST(Modes, ABoxBesideThePictureMeetsNothing) {
  Changed copy;
  copy.each("M3", [](Json& line) {
    for (auto& step : line["steps"]) {
      for (auto& argument : step["args"]) {
        if (argument.is_object()) argument["bbox"] = {-40, -40, -20, -20};
      }
    }
  });
  copy.expect_all_wrong("There is no object at the given box.");
}

TEST(Modes, WhatWasNotLookedForInM2CannotBeUsed) {
  Changed copy;
  copy.each("M2", [](Json& line) {
    auto& steps = line["steps"];
    const auto only_moves = [](const Json& step) {
      const auto name = step["action"].get<std::string>();
      return name.starts_with("go_") || name.starts_with("look_") || name.starts_with("move_") || name == "turn_to" ||
             name == "turn_left" || name == "turn_right";
    };
    steps.erase(std::remove_if(steps.begin(), steps.end(), only_moves), steps.end());
  });
  copy.expect_all_wrong("recorded as success, the replay gives");
}

TEST(Modes, ADemonstrationOfM1IsNoneOfM2) {
  Changed copy;
  copy.each("M2", [](Json& line) { line["mode"] = "M1"; });
  copy.expect_all_wrong("expected the mode \"M2\"");
}

TEST(Modes, AreNamedWhenOneIsUnknown) {
  const auto ended = run_program({"generate", "--count", "1", "--modes", "M4", "--out", "nowhere"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("accepted: M1, M2, M3"));
}

TEST(Modes, EachCanBeDrawn) {
  const ScratchFolder scratch;
  const auto task = json_lines(in_all_modes() / "tasks.jsonl").front()["id"].get<std::string>();
  for (const std::string mode : {"M2", "M3"}) {
    const auto picture = scratch.at(mode + ".png");
    const auto ended = run_program(
        {"render", in_all_modes().string(), task, "--mode", mode, "--step", "2", "--boxes", "--out", picture});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_GT(fs::file_size(picture), 1000U);
  }
}

}  // namespace
}  // namespace unietp
