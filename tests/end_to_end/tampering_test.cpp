// A data set in which something was changed: `validate` says which task is wrong and why. Except where the checksums
// themselves are tested, they are made true again first, so that the proof must come from what the files mean.
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/text.h"
#include "data_set.h"

namespace unietp {
namespace {

using testing::HasSubstr;
using Json = nlohmann::ordered_json;

/// The text with the first occurrence after `mark` of `from` replaced.
std::string changed(const std::string& text, const std::string& mark, const std::string& from, const std::string& to) {
  const auto start = text.find(mark);
  EXPECT_NE(start, std::string::npos) << mark;
  const auto at = text.find(from, start);
  EXPECT_NE(at, std::string::npos) << from;
  return text.substr(0, at) + to + text.substr(at + from.size());
}

/// Exactly this task is told to be wrong, for a reason that holds the words.
void expect_only(const Verdict& verdict, const std::string& task, const std::string& words) {
  EXPECT_EQ(verdict.code, 1);
  EXPECT_EQ(verdict.proven, kSmallCount - 1);
  ASSERT_FALSE(verdict.problems.empty());
  bool told = false;
  for (const auto& problem : verdict.problems) {
    EXPECT_EQ(problem.task, task) << problem.where << ": " << problem.message;
    told = told || problem.message.find(words) != std::string::npos;
  }
  EXPECT_TRUE(told) << "no reason with \"" << words << "\"; the first is: " << verdict.problems.front().message;
}

std::string id_of_line(const SpoiltCopy& copy, std::size_t line) {
  return Json::parse(split(copy.read("tasks.jsonl"), '\n').at(line)).at("id");
}

TEST(Tampering, AnUnchangedCopyIsProven) {
  SpoiltCopy copy;
  copy.vouch();
  const auto verdict = validate(copy.folder());
  EXPECT_EQ(verdict.code, 0);
  EXPECT_TRUE(verdict.problems.empty());
}

TEST(Tampering, AnOutcomeThatDidNotHappenIsFoundByReplay) {
  SpoiltCopy copy;
  const auto task = id_of_line(copy, 3);
  copy.write("demonstrations/M1.jsonl", changed(copy.read("demonstrations/M1.jsonl"), "\"task\":\"" + task + "\"",
                                                "\"success\":true", "\"success\":false"));
  copy.vouch();
  expect_only(validate(copy.folder()), task, "step 1 ");
}

TEST(Tampering, AnActionWithOneLetterChangedIsFound) {
  SpoiltCopy copy;
  const auto task = id_of_line(copy, 0);
  copy.write("demonstrations/M1.jsonl", changed(copy.read("demonstrations/M1.jsonl"), "\"task\":\"" + task + "\"",
                                                "\"action\":\"go_to\"", "\"action\":\"go_ta\""));
  copy.vouch();
  expect_only(validate(copy.folder()), task, "go_ta");
}

TEST(Tampering, ADigitOfAChangedPoseIsFound) {
  SpoiltCopy copy;
  const auto task = id_of_line(copy, 1);
  auto text = copy.read("demonstrations/M1.jsonl");
  const auto line = text.find("\"task\":\"" + task + "\"");
  const auto changes = text.find("\"changes\":", line);
  const auto digit = text.find_first_of("123456789", text.find("\"position\"", changes));
  ASSERT_LT(digit, text.size());
  text[digit] = text[digit] == '9' ? '8' : static_cast<char>(text[digit] + 1);
  copy.write("demonstrations/M1.jsonl", text);
  copy.vouch();
  expect_only(validate(copy.folder()), task, "other changes than recorded");
}

TEST(Tampering, AStepLeftOutIsFound) {
  SpoiltCopy copy;
  const auto task = id_of_line(copy, 2);
  auto lines = split(copy.read("demonstrations/M1.jsonl"), '\n');
  for (auto& line : lines) {
    if (line.find("\"task\":\"" + task + "\"") == std::string::npos) continue;
    auto json = Json::parse(line);
    json["steps"].erase(json["steps"].size() - 2);  // the last before stop
    line = json.dump();
  }
  copy.write("demonstrations/M1.jsonl", join(lines, "\n"));
  copy.vouch();
  expect_only(validate(copy.folder()), task, "does not reach the goal");
}

TEST(Tampering, ABrokenLineIsBlamedOnItsTask) {
  for (const auto* file : {"demonstrations/M1.jsonl", "tasks.jsonl"}) {
    SpoiltCopy copy;
    const auto task = id_of_line(copy, 4);
    auto lines = split(copy.read(file), '\n');
    lines.at(4)[0] = '[';
    copy.write(file, join(lines, "\n"));
    copy.vouch();
    const auto verdict = validate(copy.folder());
    EXPECT_EQ(verdict.code, 1);
    ASSERT_FALSE(verdict.problems.empty());
    for (const auto& problem : verdict.problems) EXPECT_EQ(problem.task, task) << problem.message;
  }
}

TEST(Tampering, AGoalWithOneByteChangedInItsTextIsFound) {
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{{"(exists", "(exist_"}, {"(", "["}}) {
    SpoiltCopy copy;
    const auto task = id_of_line(copy, 0);
    auto lines = split(copy.read("tasks.jsonl"), '\n');
    lines.at(0) = changed(lines.at(0), "\"goal\":{\"text\":\"", from, to);
    copy.write("tasks.jsonl", join(lines, "\n"));
    copy.vouch();
    expect_only(validate(copy.folder()), task, "its goal does not read, at column");
  }
}

TEST(Tampering, AGoalWithOneByteChangedInItsTreeIsFound) {
  SpoiltCopy copy;
  const auto task = id_of_line(copy, 0);
  auto lines = split(copy.read("tasks.jsonl"), '\n');
  auto& line = lines.at(0);
  const auto name = line.find("\"category\":\"", line.find("\"tree\":")) + std::string("\"category\":\"").size();
  line[name] = line[name] == 'x' ? 'y' : 'x';
  copy.write("tasks.jsonl", join(lines, "\n"));
  copy.vouch();
  expect_only(validate(copy.folder()), task, "text and tree are different formulas");
}

/// Text and tree agree, but the goal is another one: only the replay can tell.
TEST(Tampering, AGoalTurnedIntoItsOppositeIsFoundByTheEvaluator) {
  SpoiltCopy copy;
  const auto task = id_of_line(copy, 0);
  auto lines = split(copy.read("tasks.jsonl"), '\n');
  auto json = Json::parse(lines.at(0));
  const auto text = json["goal"]["text"].get<std::string>();
  json["goal"]["text"] = "(not " + text + ")";
  const Json tree = json["goal"]["tree"];
  json["goal"]["tree"] = Json{{"op", "not"}, {"parts", Json::array({tree})}};
  lines.at(0) = json.dump();
  copy.write("tasks.jsonl", join(lines, "\n"));
  copy.vouch();
  const auto verdict = validate(copy.folder());
  expect_only(verdict, task, "does not reach the goal");
  expect_only(verdict, task, "holds before anything is done");
}

TEST(Tampering, AnObjectMovedInTheSceneIsFoundByPhysics) {
  SpoiltCopy copy;
  const auto task = id_of_line(copy, 5);
  auto scene = Json::parse(copy.read_scene(task));
  for (auto& node : scene["nodes"]) {
    if (!node["movable"].get<bool>()) continue;
    auto& height = node["position"][2];
    height = height.get<double>() + 0.4;
    break;
  }
  copy.write_scene(task, scene.dump());
  copy.vouch();
  expect_only(validate(copy.folder()), task, "is not at rest");
}

TEST(Tampering, ARelationThatPhysicsDoesNotShowIsFound) {
  SpoiltCopy copy;
  const auto task = id_of_line(copy, 6);
  auto scene = Json::parse(copy.read_scene(task));
  scene["edges"].erase(0);
  copy.write_scene(task, scene.dump());
  copy.vouch();
  expect_only(validate(copy.folder()), task, "which the scene does not say");
}

TEST(Tampering, AStateThatMakesTheGoalTrueAtTheStartOrChangesTheReplayIsFound) {
  SpoiltCopy copy;
  const auto task = id_of_line(copy, 7);
  const auto text = copy.read_scene(task);
  auto scene = Json::parse(text);
  // Every joint of furniture as far open as it goes: relations, sight and outcomes change.
  for (auto& node : scene["nodes"]) {
    if (node["openable"].get<bool>() && !node["movable"].get<bool>()) node["opening"] = node["opening"] == 0 ? 1 : 0;
  }
  copy.write_scene(task, scene.dump());
  copy.vouch();
  const auto verdict = validate(copy.folder());
  EXPECT_EQ(verdict.code, 1);
  ASSERT_FALSE(verdict.problems.empty());
  for (const auto& problem : verdict.problems) EXPECT_EQ(problem.task, task) << problem.message;
}

/// One byte anywhere in a packed scene, checksums left as they were: the file and its task are named.
TEST(Tampering, OneByteOfAPackedSceneNamesTheTask) {
  SpoiltCopy copy;
  const auto task = id_of_line(copy, 8);
  const auto file = "scenes/" + task + ".scene.json.gz";
  auto bytes = copy.read(file);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  copy.write(file, bytes);
  const auto verdict = validate(copy.folder());
  expect_only(verdict, task, "SHA-256");
  EXPECT_GE(verdict.problems.size(), 2U);  // and it does not unpack, or is no scene
}

TEST(Tampering, AMissingAndASurplusFileAreNamed) {
  SpoiltCopy copy;
  const auto task = id_of_line(copy, 9);
  std::filesystem::remove(copy.folder() / "scenes" / (task + ".scene.json.gz"));
  copy.write("notes.txt", "mine");
  const auto verdict = validate(copy.folder());
  EXPECT_EQ(verdict.code, 1);
  const auto told = [&](const std::string& where, const std::string& words) {
    return std::any_of(verdict.problems.begin(), verdict.problems.end(), [&](const Verdict::Problem& problem) {
      return problem.where == where && problem.message.find(words) != std::string::npos;
    });
  };
  EXPECT_TRUE(told("scenes/" + task + ".scene.json.gz", "missing"));
  EXPECT_TRUE(told("notes.txt", "not listed"));
}

TEST(Tampering, EveryProblemIsToldNotOnlyTheFirst) {
  SpoiltCopy copy;
  auto lines = split(copy.read("tasks.jsonl"), '\n');
  const auto first = id_of_line(copy, 0), second = id_of_line(copy, 1);
  for (const std::size_t i : {0U, 1U}) lines.at(i) = changed(lines.at(i), "\"goal\":{\"text\":\"", "(", "[");
  copy.write("tasks.jsonl", join(lines, "\n"));
  const auto verdict = validate(copy.folder());
  EXPECT_EQ(verdict.proven, kSmallCount - 2);
  for (const auto& task : {first, second}) {
    EXPECT_TRUE(std::any_of(verdict.problems.begin(), verdict.problems.end(),
                            [&](const Verdict::Problem& problem) { return problem.task == task; }));
  }
  EXPECT_EQ(verdict.problems.front().where, "tasks.jsonl");  // the checksum
}

}  // namespace
}  // namespace unietp
