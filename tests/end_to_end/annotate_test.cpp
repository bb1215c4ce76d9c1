// `unietp annotate` as a user runs it: by the grammar, by a server on loopback, and by batch files.
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "../llm/wording_model.h"
#include "core/files.h"
#include "core/text.h"
#include "data_set.h"
#include "hung_server.h"
#include "program.h"
#include "schema_checker.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using test::ChatServer;
using test::Received;
using test::WordingModel;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::ordered_json;

constexpr const char* kKey = "sk-program-secret-0123456789";
constexpr int kCount = 12;

/// A data set of every simulator, made once.
const fs::path& made() {
  static const ScratchFolder folder;
  static const fs::path path = [] {
    const auto ended =
        run_program({"generate", "--count", std::to_string(kCount), "--seed", "9", "--rooms", "5", "--objects", "60",
                     "--splits", "atomic,compositional,linguistic", "--out", folder.at("made")});
    EXPECT_EQ(ended.code, 0) << ended.err;
    return fs::path(folder.at("made"));
  }();
  return path;
}

class AnnotateCommand : public ::testing::Test {
 protected:
  AnnotateCommand() {
    ::setenv("UNIETP_LLM_KEY", kKey, 1);
    fs::copy(made(), data(), fs::copy_options::recursive);
  }
  ~AnnotateCommand() override { ::unsetenv("UNIETP_LLM_KEY"); }

  fs::path data() const { return folder_.path() / "data"; }
  Ended annotate(std::vector<std::string> more) const {
    std::vector<std::string> arguments{"annotate", data().string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  }
  std::vector<std::string> model_command(const std::string& url, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"annotate",   data().string(), "--writer", "llm",     "--llm-url",
                                       url,          "--llm-model",   "tiny",     "--cache", folder_.at("answers"),
                                       "--llm-wait", "0.001"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  Ended by_model(const std::string& url, const std::vector<std::string>& more = {}) const {
    return run_program(model_command(url, more));
  }
  Ended by_batch() const {
    return annotate({"--writer", "batch", "--batch", folder_.at("batch"), "--llm-model", "tiny"});
  }
  std::vector<Json> instructions() const {
    std::vector<Json> all;
    for (const auto& task : json_lines(data() / "tasks.jsonl")) all.push_back(task["instruction"]);
    return all;
  }
  /// Sound, proven, and nothing changed but the wording.
  void expect_sound() const {
    const auto verdict = validate(data());
    EXPECT_EQ(verdict.code, 0);
    EXPECT_EQ(verdict.proven, kCount);
    SchemaChecker checker;
    EXPECT_EQ(checker.check(Json::parse(*read_file(data() / "manifest.json")), "manifest.schema.json"), "");
    auto before = json_lines(made() / "tasks.jsonl"), after = json_lines(data() / "tasks.jsonl");
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
      EXPECT_EQ(checker.check(after[i], "task.schema.json"), "");
      EXPECT_EQ(before[i]["instruction"]["style"], after[i]["instruction"]["style"]);
      for (const char* of_the_text : {"instruction", "phenomena"})
        before[i].erase(of_the_text), after[i].erase(of_the_text);
      EXPECT_EQ(before[i], after[i]);
    }
    std::vector<std::string> left;
    for (const auto& entry : fs::directory_iterator(folder_.path())) left.push_back(entry.path().filename().string());
    EXPECT_THAT(left, Not(::testing::Contains(HasSubstr(".writing"))));
    EXPECT_THAT(left, Not(::testing::Contains(HasSubstr(".lock"))));
  }
  void expect_no_key(const Ended& ended) const {
    EXPECT_THAT(ended.out + ended.err, Not(HasSubstr(kKey)));
    for (const auto& [name, bytes] : bytes_below(folder_.path())) EXPECT_THAT(bytes, Not(HasSubstr(kKey))) << name;
  }
  /// Answers to all requests in the batch folder that it has not answered, last one first, as the service gives them,
  /// but for `leave_out` of them, of which none has the body `kept`.
  void serve_batch(WordingModel& model, const std::string& file, std::size_t leave_out,
                   const nlohmann::json& kept = {}) const {
    std::vector<std::pair<bool, std::string>> answers;
    for (const auto& entry : fs::directory_iterator(folder_.at("batch"))) {
      if (!entry.path().filename().string().starts_with("requests-")) continue;
      for (const auto& line : split(*read_file(entry.path()), '\n')) {
        if (line.empty()) continue;
        const auto request = nlohmann::json::parse(line);
        EXPECT_THAT(line, Not(HasSubstr(kKey)));
        const nlohmann::json body{
            {"choices", nlohmann::json::array({{{"message", {{"content", model.content_for(request["body"])}}}}})}};
        const nlohmann::json answer{{"custom_id", request["custom_id"]},
                                    {"response", {{"status_code", 200}, {"body", body}}},
                                    {"error", nullptr}};
        answers.emplace_back(request["body"] == kept, answer.dump());
      }
    }
    std::sort(answers.rbegin(), answers.rend());
    answers.resize(answers.size() - std::min(leave_out, answers.size()));
    std::string lines;
    for (const auto& [always, line] : answers) lines += line + "\n";
    ASSERT_TRUE(write_file(fs::path(folder_.at("batch")) / file, lines));
  }
  ScratchFolder folder_;
};

TEST_F(AnnotateCommand, GivesTasksOfOneHomeAndOneGoalWordsOfTheirOwn) {
  const Json task = json_lines(data() / "tasks.jsonl").front();
  const Json demonstration = json_lines(data() / "demonstrations/M1.jsonl").front();
  std::string lines, shown;
  constexpr int kTwins = 40;  // more than a simple goal has texts of one frame
  for (int i = 0; i < kTwins; ++i) {
    Json twin = task;
    twin["id"] = task["id"].get<std::string>() + "-" + std::to_string(i);
    lines += twin.dump() + "\n";
    Json own = demonstration;
    own["task"] = twin["id"];
    shown += own.dump() + "\n";
  }
  ASSERT_TRUE(write_file(data() / "tasks.jsonl", lines));
  ASSERT_TRUE(write_file(data() / "demonstrations/M1.jsonl", shown));
  const auto ended = annotate({"--phrasings", "benchmark"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  std::set<std::string> texts;
  for (const auto& line : json_lines(data() / "tasks.jsonl")) texts.insert(line["instruction"]["text"]);
  EXPECT_EQ(texts.size(), static_cast<std::size_t>(kTwins));
}

TEST_F(AnnotateCommand, TheGrammarWithTheRunsSeedGivesTheSameTexts) {
  const auto ended = annotate({});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(bytes_below(data())["tasks.jsonl"], bytes_below(made())["tasks.jsonl"]);
  expect_sound();
}

TEST_F(AnnotateCommand, TheEnglishIsChosenRecordedAndKept) {
  ASSERT_EQ(annotate({"--english", "gb"}).code, 0);
  expect_sound();
  EXPECT_EQ(Json::parse(*read_file(data() / "manifest.json"))["instructions"]["english"], "gb");
  std::string american, british;
  for (const auto& line : json_lines(made() / "tasks.jsonl"))
    american += line["instruction"]["text"].get<std::string>();
  for (const auto& line : json_lines(data() / "tasks.jsonl")) british += line["instruction"]["text"].get<std::string>();
  EXPECT_NE(american, british);
  for (const char* word : {"trash can", "faucet", "closet", "couch"}) EXPECT_THAT(british, Not(HasSubstr(word)));
  ASSERT_EQ(annotate({}).code, 0);
  EXPECT_EQ(Json::parse(*read_file(data() / "manifest.json"))["instructions"]["english"], "gb");
  const auto unknown = annotate({"--english", "oz"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("--english"));
}

TEST_F(AnnotateCommand, AnotherSeedAndTurnsOfPhraseGiveOthers) {
  const auto ended = annotate({"--seed", "77", "--phrasings", "benchmark"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_NE(bytes_below(data())["tasks.jsonl"], bytes_below(made())["tasks.jsonl"]);
  expect_sound();
  const auto once = bytes_below(data());
  EXPECT_EQ(annotate({"--seed", "77", "--phrasings", "benchmark"}).code, 0);
  EXPECT_EQ(bytes_below(data()), once);
}

TEST_F(AnnotateCommand, ACopyLeavesTheDataSetAlone) {
  const auto before = bytes_below(data());
  EXPECT_EQ(annotate({"--seed", "9", "--out", folder_.at("copy")}).code, 0);
  EXPECT_EQ(bytes_below(data()), before);
  EXPECT_EQ(validate(folder_.at("copy")).proven, kCount);
  EXPECT_EQ(annotate({"--seed", "9", "--out", folder_.at("copy")}).code, 2);
}

TEST_F(AnnotateCommand, AModelWordsItAndARerunCostsNothing) {
  WordingModel model;
  int asked = 0;
  {
    ChatServer server([&](const Received& received) { return model(received); });
    const auto ended = by_model(server.url, {"--price-in", "1", "--price-out", "2"});
    EXPECT_EQ(ended.code, 0) << ended.err << ended.out;
    EXPECT_THAT(ended.out, HasSubstr(std::to_string(kCount) + " by llm:tiny"));
    EXPECT_THAT(ended.out, HasSubstr("cost "));
    EXPECT_THAT(server.received().at(0).head, HasSubstr(std::string("Bearer ") + kKey));
    asked = server.count();
    EXPECT_GE(asked, 2 * kCount);
    expect_no_key(ended);
    for (const auto& instruction : instructions()) EXPECT_EQ(instruction["writer"], "llm:tiny");
    expect_sound();
    const auto once = bytes_below(data());
    const auto again = by_model(server.url);
    EXPECT_EQ(again.code, 0);
    EXPECT_EQ(server.count(), asked);
    EXPECT_THAT(again.out, HasSubstr("0 in, 0 out"));
    EXPECT_EQ(bytes_below(data()), once);
  }
}

TEST_F(AnnotateCommand, WhereAnAnswerIsMissingNothingChangesAndItIsTold) {
  WordingModel model;
  int count = 0;  // one request in five has no answer
  ChatServer server([&](const Received& received) {
    return ++count % 5 == 0 ? test::http("500 Internal Server Error", "oh") : model(received);
  });
  const auto before = bytes_below(data());
  const auto ended = by_model(server.url, {"--llm-attempts", "1", "--at-once", "1"});
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.err, HasSubstr("left as it was"));
  EXPECT_THAT(ended.err, HasSubstr("status 500"));
  EXPECT_EQ(bytes_below(data()), before);
  const auto down = by_model("http://localhost:1", {"--llm-attempts", "1", "--out", folder_.at("other")});
  EXPECT_EQ(down.code, 1);
  EXPECT_FALSE(fs::exists(folder_.at("other")));
  EXPECT_EQ(bytes_below(data()), before);
  expect_sound();
}

TEST_F(AnnotateCommand, EndsWithinTwoSecondsOfASignalWhileTheServerHangsAndChangesNothing) {
  const auto before = bytes_below(data());
  ChatServer server([](const Received&) { return ChatServer::kSilence; });
  for (const int signal : {SIGTERM, SIGINT}) {
    const int known = server.count();
    RunningProgram program(model_command(server.url));
    expect_end_while_server_hangs(program, signal, [&] { return server.count() > known; });
    EXPECT_EQ(bytes_below(data()), before);
  }
  expect_sound();
}

TEST_F(AnnotateCommand, TheGrammarStandsInWhereTheModelFailsIfItMayAndTheRecordSaysWhy) {
  ChatServer server([&](const Received&) { return test::http("500 Internal Server Error", "oh"); });
  const auto ended = by_model(server.url, {"--llm-attempts", "2", "--stand-in"});
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.out, HasSubstr("the grammar wrote"));
  for (const auto& instruction : instructions()) {
    EXPECT_EQ(instruction["writer"], "grammar");
    EXPECT_THAT(instruction["why"].get<std::string>(), HasSubstr("status 500"));
  }
  expect_sound();
  expect_no_key(ended);
}

/// A person rewrites the first task, and a second one in a way that does not pass the checks.
TEST_F(AnnotateCommand, TextsByPeopleStayWhoeverWritesUnlessTheyMayBeReplaced) {
  const auto tasks = json_lines(data() / "tasks.jsonl");
  Json reviews = Json::array();
  std::map<std::string, std::string> own;
  for (const std::size_t i : {0UL, 1UL}) {
    const std::string id = tasks[i]["id"], text = tasks[i]["instruction"]["text"];
    own[id] = i == 0 ? "Now " + text : "Do what I mean.";
    reviews.push_back({{"task", id}, {"verdict", "edit"}, {"instruction", text}, {"text", own[id]}, {"comment", ""}});
  }
  ASSERT_TRUE(write_file(
      folder_.at("reviews.json"),
      Json{{"format", "unietp-review/1"}, {"set", "data"}, {"tasks_sha256", "x"}, {"reviews", reviews}}.dump()));
  const auto reviewed =
      run_program({"review", data().string(), "--apply", folder_.at("reviews.json"), "--accept-unchecked"});
  ASSERT_EQ(reviewed.code, 0) << reviewed.out << reviewed.err;
  const auto texts = [&] {
    std::map<std::string, std::string> found;
    for (const auto& task : json_lines(data() / "tasks.jsonl")) {
      if (own.contains(task["id"])) found[task["id"]] = task["instruction"]["text"];
    }
    return found;
  };
  ASSERT_EQ(texts(), own);
  const auto before = bytes_below(data());

  EXPECT_EQ(by_model("http://localhost:1", {"--llm-attempts", "1"}).code, 1);
  EXPECT_EQ(bytes_below(data()), before);

  const auto by_grammar = annotate({"--seed", "77"});
  EXPECT_EQ(by_grammar.code, 0) << by_grammar.err;
  EXPECT_THAT(by_grammar.out, HasSubstr("2 by people, kept"));
  EXPECT_EQ(texts(), own);
  EXPECT_NE(bytes_below(data())["tasks.jsonl"], before.at("tasks.jsonl"));

  WordingModel model;
  ChatServer server([&](const Received& received) { return model(received); });
  EXPECT_EQ(by_model(server.url).code, 0);
  EXPECT_EQ(texts(), own);
  for (const auto& instruction : instructions())
    EXPECT_EQ(instruction["writer"] == "llm:tiny", !instruction["writer"].get<std::string>().starts_with("person"));

  EXPECT_EQ(annotate({"--seed", "77", "--replace-human"}).code, 0);
  for (const auto& [id, text] : texts()) EXPECT_NE(text, own[id]);
}

TEST_F(AnnotateCommand, ADryRunPrintsThePromptsAndSendsNothing) {
  ChatServer server([&](const Received&) { return std::string(); });
  const auto before = bytes_below(data());
  const auto ended = by_model(server.url, {"--dry-run"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("Goal as a formula: "));
  EXPECT_EQ(server.count(), 0);
  EXPECT_EQ(bytes_below(data()), before);
  expect_no_key(ended);
}

TEST_F(AnnotateCommand, BatchFilesGoOnWhereTheAnswersEnded) {
  WordingModel model;
  auto ended = by_batch();
  EXPECT_EQ(ended.code, 1) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr(std::to_string(kCount) + " new requests"));
  EXPECT_TRUE(fs::exists(fs::path(folder_.at("batch")) / "requests-0001.jsonl"));
  expect_sound();  // as it was for the time being

  ended = by_batch();  // nothing has come: nothing is asked twice
  EXPECT_THAT(ended.out, HasSubstr(std::to_string(kCount) + " waiting, 0 failed, 0 new requests"));

  // The service gave one up: that is told, and it is asked anew.
  const auto given_up = split(*read_file(fs::path(folder_.at("batch")) / "requests-0001.jsonl"), '\n')[0];
  const auto expired = nlohmann::json::parse(given_up);
  const auto custom_id = expired["custom_id"].get<std::string>();
  const auto errors = fs::path(folder_.at("batch")) / "errors-0.jsonl";
  ASSERT_TRUE(write_file(errors, "{\"custom_id\": \"" + custom_id +
                                     "\", \"response\": null, \"error\": {\"code\": "
                                     "\"batch_expired\", \"message\": \"out of time\"}}\n"));
  ended = by_batch();
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.out, HasSubstr(std::to_string(kCount - 1) + " waiting, 1 failed, 1 new requests"));
  EXPECT_THAT(ended.out, HasSubstr("1 failed: "));
  EXPECT_THAT(ended.out, HasSubstr("out of time"));
  EXPECT_TRUE(fs::exists(fs::path(folder_.at("batch")) / "requests-0002.jsonl"));

  serve_batch(model, "answers-1.jsonl", 2, expired["body"]);  // of the wordings, two are missing
  ended = by_batch();
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.out, HasSubstr("2 waiting, 0 failed, " + std::to_string(kCount - 2) + " new requests"));

  ASSERT_TRUE(write_file(fs::path(folder_.at("batch")) / "errors.jsonl", "{\"custom_id\": \"x\", \"resp"));
  serve_batch(model, "answers-2.jsonl", 0);  // the rest of them, and the judgments
  ended = by_batch();
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.err, HasSubstr("errors.jsonl:1"));
  fs::remove(fs::path(folder_.at("batch")) / "errors.jsonl");
  serve_batch(model, "answers-3.jsonl", 0);
  ended = by_batch();
  EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_THAT(ended.out, HasSubstr(std::to_string(kCount) + " by llm:tiny"));
  expect_sound();
  expect_no_key(ended);
}

TEST_F(AnnotateCommand, WhatIsMissingIsToldBeforeAnythingIsDone) {
  const auto before = bytes_below(data());
  for (const auto& [options, message] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"--writer", "poet"}, "grammar"},
           {{"--writer", "llm"}, "--llm-url"},
           {{"--writer", "llm", "--llm-url", "http://localhost:1"}, "--llm-model"},
           {{"--writer", "batch", "--llm-model", "tiny"}, "--batch"},
           {{"--phrasings", "old"}, "training"},
           {{"--wordings", "1"}, "--wordings"}}) {
    const auto ended = annotate(options);
    EXPECT_EQ(ended.code, 2) << message;
    EXPECT_THAT(ended.err, HasSubstr(message));
  }
  EXPECT_EQ(bytes_below(data()), before);
}

TEST_F(AnnotateCommand, GenerateTakesTheSameOptions) {
  WordingModel model;
  ChatServer server([&](const Received& received) { return model(received); });
  const auto ended = run_program({"generate",
                                  "--count",
                                  "2",
                                  "--seed",
                                  "5",
                                  "--rooms",
                                  "5",
                                  "--objects",
                                  "25",
                                  "--simulators",
                                  "ai2thor",
                                  "--splits",
                                  "atomic",
                                  "--writer",
                                  "llm",
                                  "--llm-url",
                                  server.url,
                                  "--llm-model",
                                  "tiny",
                                  "--cache",
                                  folder_.at("answers"),
                                  "--out",
                                  folder_.at("worded")});
  EXPECT_EQ(ended.code, 0) << ended.err;
  for (const auto& task : json_lines(folder_.path() / "worded" / "tasks.jsonl"))
    EXPECT_EQ(task["instruction"]["writer"], "llm:tiny");
  EXPECT_EQ(validate(folder_.at("worded")).proven, 2);
}

}  // namespace
}  // namespace unietp
