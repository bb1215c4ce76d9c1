// Chats for fine-tuning, held against what their three readers ask for. The rules were read in those readers:
//  - LLaMA-Factory: data/converter.py (SharegptDatasetConverter), data/parser.py, data/mm_plugin.py;
//  - TRL: data_utils.py (is_conversational, prepare_multimodal_messages), trainer/sft_trainer.py;
//  - ms-swift: docs, "Custom dataset" (messages, images, <image>, loss), llm/dataset/preprocessor/core.py;
//  - all three load the lines with Hugging Face's datasets, whose tables have one type a column.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>

#include "core/files.h"
#include "core/text.h"
#include "data_set.h"
#include "schema_checker.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::ordered_json;

void export_sft(const fs::path& out, const std::vector<std::string>& options) {
  std::vector<std::string> all{"export", data_set_in_all_modes().string(), "--format", "sft", "--out", out.string()};
  all.insert(all.end(), options.begin(), options.end());
  const auto ended = run_program(all);
  ASSERT_EQ(ended.code, 0) << ended.err;
}

std::size_t count_of(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

/// Columns by which a reader would take a line for another kind of data.
const std::set<std::string> kOtherKinds{"prompt",
                                        "completion",
                                        "chosen",
                                        "rejected",
                                        "label",
                                        "system",
                                        "conversation",
                                        "conversations",
                                        "query",
                                        "response",
                                        "text",
                                        "system_prompt",
                                        "instruction",
                                        "input",
                                        "output",
                                        "rejected_messages",
                                        "rejected_response",
                                        "tools",
                                        "objects",
                                        "videos",
                                        "audios"};

/// What is at a path of several lines is of one type, or missing.
void expect_one_type(const Json& value, const std::string& path, std::map<std::string, std::string>& types) {
  const std::string type = value.is_number() ? "number" : value.type_name();
  EXPECT_EQ(types.try_emplace(path, type).first->second, type) << path;
  if (value.is_object())
    for (const auto& [name, field] : value.items()) expect_one_type(field, path + "." + name, types);
  if (value.is_array())
    for (const Json& item : value) expect_one_type(item, path + "[]", types);
}

void expect_table(const std::vector<Json>& lines) {
  std::map<std::string, std::string> types;
  for (const Json& line : lines) {
    expect_one_type(line, "", types);
    for (const auto& [name, column] : line.items()) EXPECT_FALSE(kOtherKinds.contains(name)) << name;
  }
}

/// As LLaMA-Factory and ms-swift read a line: texts, one mark a picture, user and assistant by turns.
void expect_marked_chat(const Json& line, const fs::path& folder) {
  const Json& messages = line["messages"];
  ASSERT_EQ(messages[0]["role"], "system");
  ASSERT_EQ(messages.size() % 2, 1U);
  std::size_t marks = 0;
  for (std::size_t i = 0; i < messages.size(); ++i) {
    if (i > 0) {
      EXPECT_EQ(messages[i]["role"], i % 2 == 1 ? "user" : "assistant");
    }
    ASSERT_TRUE(messages[i]["content"].is_string());
    EXPECT_FALSE(messages[i]["content"].get<std::string>().empty());
    if (messages[i].contains("loss")) {
      EXPECT_TRUE(messages[i]["loss"].is_boolean());
    }
    EXPECT_EQ(messages[i].contains("loss"), messages[i]["role"] == "assistant");
    const auto here = count_of(messages[i]["content"], "<image>");
    EXPECT_TRUE(here == 0 || messages[i]["role"] == "user");
    marks += here;
  }
  EXPECT_EQ(line.contains("images") ? line["images"].size() : 0, marks);
  const Json images = line.value("images", Json::array());
  for (const auto& image : images) EXPECT_TRUE(fs::exists(folder / image)) << image;
}

/// As TRL reads a line with pictures: lists of parts, as many image parts as images.
void expect_parts(const Json& line) {
  std::size_t pictures = 0;
  for (const auto& message : line["messages"]) {
    ASSERT_TRUE(message["content"].is_array());
    for (const auto& part : message["content"]) {
      pictures += part["type"] == "image" ? 1 : 0;
      EXPECT_EQ(part.contains("text"), part["type"] == "text");
      if (part.contains("text")) {
        EXPECT_THAT(part["text"].get<std::string>(), Not(HasSubstr("<image>")));
      }
    }
  }
  EXPECT_EQ(line["images"].size(), pictures);
}

/// The actions of a task's demonstration.
std::vector<Json> actions_of(const std::string& mode, const std::string& task) {
  std::vector<Json> actions;
  for (const auto& line : json_lines(data_set_in_all_modes() / "demonstrations" / (mode + ".jsonl"))) {
    if (line["task"] != task) continue;
    for (const auto& step : line["steps"]) actions.push_back({{"action", step["action"]}, {"args", step["args"]}});
  }
  return actions;
}

TEST(ExportSft, EpisodesAreChatsThatEachReaderTakes) {
  const ScratchFolder scratch;
  const fs::path out = scratch.at("sft");
  export_sft(out, {});
  SchemaChecker checker;
  const auto info = Json::parse(*read_file(out / "dataset_info.json"));
  EXPECT_EQ(checker.check(info, "dataset_info.schema.json"), "");
  EXPECT_EQ(info.size(), 2U) << "M3 shows pictures alone";
  for (const auto& [name, entry] : info.items()) {
    const std::string file = entry["file_name"];
    const auto lines = json_lines(out / file);
    EXPECT_EQ(lines.size(), static_cast<std::size_t>(kCountInAllModes));
    expect_table(lines);
    for (const auto& line : lines) {
      SCOPED_TRACE(line["id"].get<std::string>());
      EXPECT_EQ(checker.check(line, "sft.schema.json"), "");
      EXPECT_FALSE(line.contains(entry["columns"].value("images", "images"))) << "TRL takes such a column for pictures";
      expect_marked_chat(line, out);
      const std::string id = line["id"];
      const auto actions = actions_of(file.substr(0, 2), id.substr(0, id.find('/')));
      ASSERT_EQ(line["messages"].size(), 2 * actions.size() + 1);
      for (std::size_t i = 0; i < actions.size(); ++i) {
        const auto answer = Json::parse(line["messages"][2 * i + 2]["content"].get<std::string>());
        EXPECT_EQ(answer, actions[i]);
        EXPECT_EQ(checker.check(answer, "action.schema.json"), "");
      }
    }
  }
}

/// A copy of the data set in whose M2 every third step failed, the first of them the second.
class WithFailures {
 public:
  WithFailures() : folder_(scratch_.at("copy")) {
    fs::copy(data_set_in_all_modes(), folder_, fs::copy_options::recursive);
    std::string lines;
    for (auto line : json_lines(folder_ / "demonstrations" / "M2.jsonl")) {
      auto& succeeded = succeeded_[line["task"].get<std::string>()];
      for (auto& step : line["steps"]) {
        if (succeeded.size() % 3 == 1) step["success"] = false, step["feedback"] = "Something is in the way.";
        succeeded.push_back(step["success"]);
      }
      lines += line.dump() + "\n";
    }
    EXPECT_TRUE(write_file(folder_ / "demonstrations" / "M2.jsonl", lines));
  }
  const std::map<std::string, std::vector<bool>>& succeeded() const { return succeeded_; }

  /// The lines of M2 as chats, one an episode or one a step.
  std::vector<Json> chats(const std::string& unit) const {
    const auto out = scratch_.at(unit);
    const auto ended =
        run_program({"export", folder_.string(), "--format", "sft", "--modes", "M2", "--unit", unit, "--out", out});
    EXPECT_EQ(ended.code, 0) << ended.err;
    return json_lines(fs::path(out) / "M2.jsonl");
  }

 private:
  ScratchFolder scratch_;
  fs::path folder_;
  std::map<std::string, std::vector<bool>> succeeded_;  // by task
};

TEST(ExportSft, OnlyWhatSucceededIsToBeLearned) {
  const WithFailures set;
  for (const auto& line : set.chats("episode")) {
    const std::string id = line["id"];
    const auto& succeeded = set.succeeded().at(id.substr(0, id.find('/')));
    std::vector<bool> learned;
    for (const auto& message : line["messages"]) {
      if (message["role"] == "assistant") learned.push_back(message["loss"]);
    }
    EXPECT_EQ(learned, succeeded) << id;
  }
  for (const auto& line : set.chats("step")) {
    const auto parts = split(line["id"].get<std::string>(), '/');  // task, mode, number of the step
    const auto& succeeded = set.succeeded().at(std::string(parts.at(0)));
    EXPECT_EQ(line["messages"].back()["loss"], succeeded.at(std::stoul(std::string(parts.at(2))) - 1)) << line["id"];
  }
}

TEST(ExportSft, APromptTellsWhatTheModeKnowsAndOffers) {
  const ScratchFolder scratch;
  const fs::path out = scratch.at("sft");
  export_sft(out, {"--unit", "step"});
  for (const auto& task : json_lines(data_set_in_all_modes() / "tasks.jsonl")) {
    const auto scene = start_json(data_set_in_all_modes(), task);
    for (const std::string mode : {"M1", "M2"}) {
      const auto lines = json_lines(out / (mode + ".jsonl"));
      const auto wanted = task["id"].get<std::string>() + "/" + mode + "/1";
      const auto found =
          std::find_if(lines.begin(), lines.end(), [&](const Json& line) { return line["id"] == wanted; });
      ASSERT_NE(found, lines.end());
      const std::string prompt = (*found)["messages"][0]["content"];
      const std::string known = prompt.substr(prompt.find("What you know"));
      for (const auto& room : scene["rooms"]) EXPECT_THAT(known, HasSubstr(room["id"].get<std::string>()));
      for (const auto& node : scene["nodes"]) {
        const bool told = mode == "M1" || !node["movable"];
        for (const char* end : {",", "."}) {
          if (!told) {
            EXPECT_THAT(known, Not(HasSubstr(" " + node["id"].get<std::string>() + end)));
          }
        }
        if (told) {
          EXPECT_THAT(known, HasSubstr(node["id"].get<std::string>()));
        }
      }
      const bool heats = task["simulator"] == "ai2thor" && mode == "M1";
      EXPECT_EQ(prompt.find("- heat_with(tool)") != std::string::npos, heats);
      EXPECT_THAT((*found)["messages"][1]["content"].get<std::string>(),
                  HasSubstr(task["instruction"]["text"].get<std::string>()));
    }
  }
}

TEST(ExportSft, StepsOfM3ShowThePictureThatRenderDraws) {
  const ScratchFolder scratch;
  const fs::path out = scratch.at("sft");
  export_sft(out, {"--modes", "M3", "--unit", "step", "--observation", "image", "--threads", "2", "--reasoning"});
  SchemaChecker checker;
  const auto lines = json_lines(out / "M3.jsonl");
  const auto trl = json_lines(out / "M3.trl.jsonl");
  ASSERT_EQ(trl.size(), lines.size());
  ASSERT_GT(lines.size(), 20U);
  expect_table(lines);
  expect_table(trl);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(checker.check(lines[i], "sft.schema.json"), "");
    EXPECT_EQ(checker.check(trl[i], "sft.schema.json"), "");
    ASSERT_EQ(lines[i]["messages"].size(), 3U);
    ASSERT_EQ(lines[i]["images"].size(), 1U);
    expect_marked_chat(lines[i], out);
    expect_parts(trl[i]);
  }
  const std::string id = lines[4]["id"];
  const auto task = id.substr(0, id.find('/'));
  const auto drawn = scratch.at("drawn.png");
  const auto ended = run_program({"render", data_set_in_all_modes().string(), task, "--mode", "M3", "--step",
                                  id.substr(id.rfind('/') + 1), "--out", drawn});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(*read_file(drawn), *read_file(out / lines[4]["images"][0].get<std::string>()));
  for (const auto& line : lines) {  // nothing has an id there
    const auto answer = Json::parse(line["messages"][2]["content"].get<std::string>());
    EXPECT_THAT(answer["reasoning"].get<std::string>(), Not(::testing::ContainsRegex("[a-z]_[0-9]+ (is|are)")));
  }
}

TEST(ExportSft, ReasonsNameOnlyWhatTheAgentHasBeenToldOrHasSeen) {
  const ScratchFolder scratch;
  const fs::path out = scratch.at("sft");
  export_sft(out, {"--modes", "M2", "--reasoning"});
  std::size_t reasons = 0;
  std::map<std::string, Json> scenes;  // by task
  for (const auto& task : json_lines(data_set_in_all_modes() / "tasks.jsonl"))
    scenes[task["id"]] = start_json(data_set_in_all_modes(), task);
  for (const auto& line : json_lines(out / "M2.jsonl")) {
    const std::string id = line["id"];
    const Json& scene = scenes.at(id.substr(0, id.find('/')));
    std::string told;
    for (const auto& message : line["messages"]) {
      const std::string content = message["content"];
      if (message["role"] != "assistant") {
        told += content + " ";
        continue;
      }
      const std::string reason = Json::parse(content)["reasoning"];
      ++reasons;
      for (const auto& node : scene["nodes"]) {
        const auto name = node["id"].get<std::string>();
        if (count_of(" " + reason, " " + name + " ") > 0) {
          EXPECT_THAT(told, HasSubstr(name)) << reason;
        }
      }
    }
  }
  EXPECT_GT(reasons, 30U);
}

TEST(ExportSft, EqualOptionsGiveEqualBytesOnAnyNumberOfThreads) {
  const ScratchFolder scratch;
  export_sft(scratch.at("one"), {"--reasoning", "--threads", "1"});
  export_sft(scratch.at("two"), {"--reasoning", "--threads", "3"});
  EXPECT_EQ(bytes_below(scratch.at("one")), bytes_below(scratch.at("two")));
}

TEST(ExportSft, TellsWhichModesItWroteAndWhichItLeftOut) {
  const ScratchFolder scratch;
  const auto ended =
      run_program({"export", data_set_in_all_modes().string(), "--format", "sft", "--out", scratch.at("sft")});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr(" samples of M1, M2 in " + scratch.at("sft")));
  EXPECT_THAT(ended.out, HasSubstr("\nM3 left out: it shows only pictures"));
}

TEST(ExportSft, WhatCannotBeShownIsRefused) {
  const ScratchFolder scratch;
  const auto blind = run_program(
      {"export", data_set_in_all_modes().string(), "--format", "sft", "--modes", "M3", "--out", scratch.at("sft")});
  EXPECT_EQ(blind.code, 2);
  EXPECT_THAT(blind.err, HasSubstr("M3 has only images"));
  EXPECT_FALSE(fs::exists(scratch.at("sft")));
}

/// The answers that are not learned are mistakes: they fail, or are undone at once; without them and what undoes them,
/// what is left is the demonstration.
TEST(ExportSft, PutsMistakesWithTheirFeedbackAmongTheSteps) {
  const ScratchFolder scratch;
  const fs::path with = scratch.at("with"), again = scratch.at("again"), without = scratch.at("without");
  export_sft(with, {"--mistakes", "0.5"});
  export_sft(again, {"--mistakes", "0.5", "--threads", "2"});
  export_sft(without, {"--mistakes", "0"});
  std::set<std::string> reasons;
  std::size_t undone = 0;
  for (const std::string mode : {"M1", "M2"}) {
    SCOPED_TRACE(mode);
    EXPECT_EQ(*read_file(with / (mode + ".jsonl")), *read_file(again / (mode + ".jsonl")));
    const auto lines = json_lines(with / (mode + ".jsonl")), right = json_lines(without / (mode + ".jsonl"));
    ASSERT_EQ(lines.size(), right.size());
    std::size_t failed = 0, unchanged = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      expect_marked_chat(lines[i], with);
      std::vector<std::string> kept, wanted;
      const Json& messages = lines[i]["messages"];
      for (std::size_t k = 2; k < messages.size(); k += 2) {
        if (messages[k]["loss"] == true) {
          kept.push_back(messages[k]["content"]);
          continue;
        }
        const std::string told = messages[k + 1]["content"];
        const std::string reason = told.substr(0, told.find('\n'));
        if (reason.find("failed") != std::string::npos) {
          ++failed;
          reasons.insert(reason.substr(reason.rfind(' ')));
        } else {
          ++undone;
          EXPECT_THAT(messages[k + 2]["content"].get<std::string>(), HasSubstr("place_"));
          k += 2;
        }
      }
      for (std::size_t k = 2; k < right[i]["messages"].size(); k += 2) {
        EXPECT_EQ(right[i]["messages"][k]["loss"], true);
        wanted.push_back(right[i]["messages"][k]["content"]);
      }
      EXPECT_EQ(kept, wanted);
      unchanged += messages.size() == right[i]["messages"].size() ? 1 : 0;
    }
    EXPECT_GT(failed, lines.size() / 4);
    EXPECT_LT(unchanged, lines.size() * 3 / 4);
  }
  EXPECT_GT(undone, 0U);
  EXPECT_GE(reasons.size(), 3U);
  for (const std::string bad : {"0.6", "-1", "nan", "much"}) {
    const auto ended = run_program(
        {"export", data_set_in_all_modes().string(), "--format", "sft", "--out", scratch.at("bad"), "--mistakes", bad});
    EXPECT_EQ(ended.code, 2) << bad;
  }
}

/// Where things are named by boxes, too: each mistake fails, and without them the steps of the demonstration are left.
TEST(ExportSft, PutsMistakesAmongTheStepsOfM3) {
  const ScratchFolder scratch;
  const fs::path out = scratch.at("sft");
  export_sft(out, {"--modes", "M3", "--observation", "image", "--mistakes", "0.5", "--threads", "2"});
  std::map<std::string, std::size_t> steps;  // by task
  for (const Json& shown : json_lines(data_set_in_all_modes() / "demonstrations" / "M3.jsonl"))
    steps[shown["task"]] = shown["steps"].size();
  std::size_t failed = 0;
  for (const Json& line : json_lines(out / "M3.jsonl")) {
    expect_marked_chat(line, out);
    const Json& messages = line["messages"];
    std::size_t learned = 0;
    for (std::size_t k = 2; k < messages.size(); k += 2) {
      if (messages[k]["loss"] == true) {
        ++learned;
        continue;
      }
      ++failed;
      EXPECT_THAT(messages[k + 1]["content"].get<std::string>(), HasSubstr("failed"));
    }
    const std::string id = line["id"];
    EXPECT_EQ(learned, steps.at(id.substr(0, id.find('/')))) << id;
  }
  EXPECT_GT(failed, 0U) << "few of the later actions can be pointed at early";
}

}  // namespace
}  // namespace unietp
