// `unietp annotate --paired`, `--wordings` and `--contrasts` as a user runs them.
#include <algorithm>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/text.h"
#include "data_set.h"
#include "program.h"
#include "schema_checker.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

constexpr int kTasks = 12;

/// A data set of every simulator, made once.
const fs::path& unpaired() {
  static const ScratchFolder folder;
  static const fs::path path = [] {
    const auto ended =
        run_program({"generate", "--count", std::to_string(kTasks), "--seed", "12", "--rooms", "5", "--objects", "60",
                     "--splits", "atomic,compositional,linguistic", "--out", folder.at("made")});
    EXPECT_EQ(ended.code, 0) << ended.err;
    return fs::path(folder.at("made"));
  }();
  return path;
}

class PairedWordings : public ::testing::Test {
 protected:
  PairedWordings() { fs::copy(unpaired(), data(), fs::copy_options::recursive); }

  fs::path data() const { return folder_.path() / "data"; }
  Ended annotate(std::vector<std::string> more) const {
    std::vector<std::string> arguments{"annotate", data().string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  }
  std::vector<Json> lines() const { return json_lines(data() / "wordings.jsonl"); }
  void write_lines(const std::string& file, const std::vector<Json>& lines) const {
    std::string text;
    for (const auto& line : lines) text += line.dump() + "\n";
    ASSERT_TRUE(write_file(data() / file, text));
  }
  void expect_sound() const {
    const auto verdict = validate(data());
    EXPECT_EQ(verdict.code, 0);
    EXPECT_EQ(verdict.proven, kTasks);
  }
  ScratchFolder folder_;
};

TEST_F(PairedWordings, ContrastsDifferInOneWordAndMeanSomethingElse) {
  ASSERT_EQ(annotate({"--contrasts"}).code, 0);
  expect_sound();
  int contrasts = 0;
  for (const auto& line : lines()) {
    if (!line.contains("contrast")) continue;
    ++contrasts;
    const auto one = split(line["direct"]["text"].get<std::string>(), ' ');
    const auto other = split(line["contrast"]["text"].get<std::string>(), ' ');
    ASSERT_EQ(one.size(), other.size());
    int differ = 0;
    for (std::size_t i = 0; i < one.size(); ++i) differ += one[i] == other[i] ? 0 : 1;
    EXPECT_EQ(differ, 1) << line["contrast"]["text"];
  }
  EXPECT_GE(contrasts, kTasks / 2);
  // The same text cannot have both goals.
  auto forged = lines();
  for (auto& line : forged)
    if (line.contains("contrast")) line["contrast"]["text"] = line["direct"]["text"];
  write_lines("wordings.jsonl", forged);
  const auto ended = run_program({"validate", data().string()});
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.out + ended.err, HasSubstr("its contrast does not differ from the direct wording in one word"));
}

TEST_F(PairedWordings, PairsHaveOneEpisodeInThreeWordings) {
  const auto ended = annotate({"--paired"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  expect_sound();
  SchemaChecker checker;
  int referring = 0, complex = 0;
  const auto pairs = lines();
  const auto tasks = json_lines(data() / "tasks.jsonl");
  ASSERT_EQ(pairs.size(), tasks.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_EQ(checker.check(pairs[i], "wordings.schema.json"), "");
    EXPECT_EQ(pairs[i]["pair"], tasks[i]["id"]);
    EXPECT_EQ(pairs[i]["direct"]["style"], "direct");
    if (pairs[i].contains("complex")) {
      ++complex;
      EXPECT_NE(pairs[i]["complex"]["style"], "direct");
    }
    if (!pairs[i].contains("referring")) continue;
    ++referring;
    EXPECT_THAT(pairs[i]["referring"]["goal"].get<std::string>(), HasSubstr(":where"));
    EXPECT_NE(pairs[i]["referring"]["text"], pairs[i]["direct"]["text"]);
  }
  EXPECT_GT(complex, kTasks / 2);
  EXPECT_GT(referring, 0);
  EXPECT_EQ(annotate({}).code, 0);
  EXPECT_FALSE(fs::exists(data() / "wordings.jsonl"));
}

/// Texts of a line of wordings.jsonl that mean the task's goal.
std::vector<std::string> texts_of_goal(const Json& line) {
  std::vector<std::string> texts{line["direct"]["text"]};
  if (line.contains("complex")) texts.push_back(line["complex"]["text"]);
  if (line.contains("others"))
    for (const Json& other : line["others"]) texts.push_back(other["text"]);
  return texts;
}

TEST_F(PairedWordings, AsManyWordingsOfAGoalAsAreAskedForAllDiffer) {
  ASSERT_EQ(annotate({"--paired"}).code, 0);
  for (const auto& line : lines()) EXPECT_GE(texts_of_goal(line).size(), 2U) << line;
  const auto ended = annotate({"--wordings", "5"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  expect_sound();
  SchemaChecker checker;
  std::map<std::size_t, int> tasks;
  for (const auto& line : lines()) {
    EXPECT_EQ(checker.check(line, "wordings.schema.json"), "");
    const auto texts = texts_of_goal(line);
    EXPECT_EQ(std::set<std::string>(texts.begin(), texts.end()).size(), texts.size()) << line;
    EXPECT_LE(texts.size(), 5U);
    ++tasks[texts.size()];
  }
  EXPECT_GE(tasks[5], kTasks / 2);
  for (const auto& [wordings, count] : tasks)
    EXPECT_THAT(ended.out, HasSubstr(std::to_string(count) + " tasks with " + std::to_string(wordings) + " wordings"));
  const auto once = bytes_below(data());
  ASSERT_EQ(annotate({"--wordings", "5"}).code, 0);
  EXPECT_EQ(bytes_below(data()), once);
}

TEST_F(PairedWordings, AWordingThatIsThereTwiceOrMeansSomethingElseIsRefused) {
  ASSERT_EQ(annotate({"--wordings", "5", "--contrasts"}).code, 0);
  const auto made = lines();
  const auto refusal = [&](const char* text_of) {
    auto forged = made;
    const auto line = std::find_if(forged.begin(), forged.end(),
                                   [&](const Json& one) { return one.contains("others") && one.contains(text_of); });
    if (line == forged.end()) return std::string("no line has both");
    (*line)["others"][0]["text"] = (*line)[text_of]["text"];
    write_lines("wordings.jsonl", forged);
    const auto ended = run_program({"validate", data().string()});
    EXPECT_EQ(ended.code, 1);
    return ended.out + ended.err;
  };
  EXPECT_THAT(refusal("direct"), HasSubstr("twice"));
  EXPECT_THAT(refusal("contrast"), HasSubstr("the text asks for"));
}

/// The text of the first task is a person's and stays, but its goal has no words, so that its wordings fail.
TEST_F(PairedWordings, PairsThatFailLeaveNothingBehind) {
  auto tasks = json_lines(data() / "tasks.jsonl");
  tasks[0]["goal"]["text"] = "(exists (?a - Unnamed) (at-end (open ?a)))";
  tasks[0]["instruction"]["writer"] = "person";
  write_lines("tasks.jsonl", tasks);
  const auto before = bytes_below(folder_.path());
  const auto ended = annotate({"--paired"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("the grammar found no text"));
  EXPECT_EQ(bytes_below(folder_.path()), before);
  std::vector<std::string> left;
  for (const auto& entry : fs::directory_iterator(folder_.path())) left.push_back(entry.path().filename().string());
  EXPECT_THAT(left, ::testing::ElementsAre("data"));
}

/// A person may take each wording over: whoever reads a text reads it in its home, and alike.
TEST(PairedWordingsOfTraining, AreReadAlikeByEveryReader) {
  const ScratchFolder folder;
  const auto data = folder.at("data"), out = folder.at("reviewed");
  ASSERT_EQ(run_program({"training", "--count", std::to_string(kTasks), "--seed", "31", "--out", data}).code, 0);
  ASSERT_EQ(run_program({"annotate", data, "--wordings", "4", "--contrasts"}).code, 0);
  EXPECT_EQ(validate(data).proven, kTasks);
  const auto tasks = json_lines(fs::path(data) / "tasks.jsonl"), lines = json_lines(fs::path(data) / "wordings.jsonl");
  ASSERT_EQ(lines.size(), tasks.size());
  Json edits = Json::array();
  int contrasts = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto& now = tasks[i]["instruction"];
    EXPECT_GE(texts_of_goal(lines[i]).size(), 2U) << lines[i];
    if (lines[i].contains("contrast")) {
      ++contrasts;
      EXPECT_NE(lines[i]["contrast"]["goal"], tasks[i]["goal"]["text"]);
    }
    std::vector<Json> wordings{lines[i]["direct"]};
    if (lines[i].contains("others"))
      wordings.insert(wordings.end(), lines[i]["others"].begin(), lines[i]["others"].end());
    const auto other = std::find_if(wordings.begin(), wordings.end(), [&](const Json& one) {
      return one["style"] == now["style"] && one["text"] != now["text"];
    });
    if (other == wordings.end()) continue;
    edits.push_back({{"task", tasks[i]["id"]},
                     {"verdict", "edit"},
                     {"instruction", now["text"]},
                     {"text", (*other)["text"]},
                     {"comment", ""}});
  }
  EXPECT_GE(contrasts, kTasks / 2);
  ASSERT_GE(edits.size(), kTasks / 2U);
  const Json file{{"format", "unietp-review/1"}, {"set", "data"}, {"tasks_sha256", "x"}, {"reviews", edits}};
  ASSERT_TRUE(write_file(folder.at("review.json"), file.dump()));
  const auto ended = run_program({"review", data, "--apply", folder.at("review.json"), "--out", out});
  EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_THAT(ended.out, HasSubstr(std::to_string(edits.size()) + " edited, 0 not applied"));
  EXPECT_EQ(validate(out).proven, kTasks);
}

}  // namespace
}  // namespace unietp
