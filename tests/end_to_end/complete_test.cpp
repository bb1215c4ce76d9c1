// `unietp knowledge complete` as a user runs it, against a server on loopback.
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <thread>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "../llm/model.h"
#include "core/files.h"
#include "core/folder_lock.h"
#include "hung_server.h"
#include "program.h"
#include "schema_checker.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using test::answer_all;
using test::ChatServer;
using test::http;
using test::Received;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using Json = nlohmann::json;

constexpr const char* kKey = "sk-program-secret-0123456789";

class CompleteCommand : public ::testing::Test {
 protected:
  CompleteCommand() { ::setenv("UNIETP_LLM_KEY", kKey, 1); }
  ~CompleteCommand() override { ::unsetenv("UNIETP_LLM_KEY"); }

  /// A copy of the data and templates of its own, by name.
  std::string data(const std::string& name) {
    const fs::path root = folder_.path() / name;
    fs::create_directories(root / "templates");
    fs::copy(fs::path(UNIETP_SOURCE_DIR) / "data", root / "data", fs::copy_options::recursive);
    fs::copy(fs::path(UNIETP_SOURCE_DIR) / "templates/library", root / "templates/library",
             fs::copy_options::recursive);
    // Whatever the tables tell by now, here they lack all names and phrases.
    EXPECT_TRUE(write_file(root / "data/akb/ai2thor/alias.csv", "category,kind,text,source,confidence\n"));
    return root.string();
  }
  std::vector<std::string> command(const std::string& root, const ChatServer& server,
                                   std::vector<std::string> more = {}) {
    std::vector<std::string> arguments{
        "knowledge",       "complete",   "ai2thor",     "--data",  root,
        "--llm-url",       server.url,   "--llm-model", "tiny",    "--cache",
        root + ".answers", "--llm-wait", "0.001",       "--facts", "function,context,aliases"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  static std::map<std::string, std::string> completed(const std::string& root) {
    const auto folder = fs::path(root) / "data" / "akb" / "completed";
    return fs::exists(folder) ? bytes_below(folder) : std::map<std::string, std::string>();
  }
  void expect_no_key(const Ended& ended) {
    EXPECT_THAT(ended.out, Not(HasSubstr(kKey)));
    EXPECT_THAT(ended.err, Not(HasSubstr(kKey)));
    for (const auto& [name, bytes] : bytes_below(folder_.path())) EXPECT_THAT(bytes, Not(HasSubstr(kKey))) << name;
  }
  ScratchFolder folder_;
};

TEST_F(CompleteCommand, FillsGapsThatTheOtherCommandsThenShow) {
  ChatServer server(answer_all);
  const auto root = data("own");
  const auto ended = run_program(command(root, server, {"--json", "--price-in", "1", "--price-out", "2"}));
  EXPECT_EQ(ended.code, 0) << ended.err;
  const auto json = Json::parse(ended.out);
  const int asked = json["requests"]["asked"];
  EXPECT_EQ(asked, server.count());
  EXPECT_EQ(json["accepted"]["function"], json["lacking"]["function"]);
  EXPECT_EQ(json["tokens"]["prompt"], 11 * asked);
  EXPECT_DOUBLE_EQ(json["cost"], (11 + 2 * 7) * asked / 1e6);
  EXPECT_THAT(server.received().at(0).head, HasSubstr(std::string("Bearer ") + kKey));
  expect_no_key(ended);

  const auto shown = run_program({"knowledge", "show", "ai2thor", "Floor", "--data", root});
  EXPECT_THAT(shown.out, HasSubstr("something useful at home [llm:tiny, confidence 0.5]")) << shown.err;

  const auto again = run_program(command(root, server, {"--json"}));
  EXPECT_EQ(again.code, 0);
  EXPECT_EQ(Json::parse(again.out)["requests"]["asked"], 0);
  EXPECT_EQ(server.count(), asked);
}

TEST_F(CompleteCommand, WhatItPrintsForProgramsIsAsItsSchemaSays) {
  // The first request is refused for good, the others are answered: facts accepted and rejected, and a failure.
  ChatServer server([](const Received& received) {
    return received.number == 0 ? http("403 Forbidden", "not this one") : answer_all(received);
  });
  const auto ended = run_program(command(data("own"), server, {"--json", "--at-once", "1", "--price-out", "2"}));
  EXPECT_EQ(ended.code, 1) << ended.err;
  const auto json = nlohmann::ordered_json::parse(ended.out);
  for (const char* part : {"failures", "accepted", "rejected"}) EXPECT_FALSE(json[part].empty()) << part;
  EXPECT_EQ(SchemaChecker().check(json, "knowledge-complete.schema.json"), "");
}

TEST_F(CompleteCommand, KilledAndRunAgainGivesTheBytesOfOneRun) {
  ChatServer calm(answer_all);
  const auto whole = data("whole");
  ASSERT_EQ(run_program(command(whole, calm)).code, 0);
  for (const int signal : {SIGKILL, SIGINT}) {
    std::atomic<bool> killed = false;
    ChatServer server([&](const Received& received) {
      return received.number < 3 || killed ? answer_all(received) : ChatServer::kSilence;
    });
    const auto root = data("halved-" + std::to_string(signal));
    {
      RunningProgram running(command(root, server));
      while (running.running() && server.count() < 7) std::this_thread::yield();
      running.send(signal);
      const auto ended = running.wait();
      if (signal == SIGINT) {
        EXPECT_EQ(ended.code, 130) << ended.err;
        EXPECT_THAT(ended.out, HasSubstr("3 asked"));
        EXPECT_THAT(completed(root), Not(IsEmpty()));
      } else {
        EXPECT_EQ(ended.signal, SIGKILL);
      }
    }
    killed = true;
    const auto ended = run_program(command(root, server));
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(completed(root), completed(whole));
  }
}

TEST_F(CompleteCommand, EndsWithinTwoSecondsOfASignalWhileTheServerHangs) {
  ChatServer server([](const Received&) { return ChatServer::kSilence; });
  RunningProgram program(command(data("own"), server));
  expect_end_while_server_hangs(program, SIGTERM, [&] { return server.count() > 0; });
}

TEST_F(CompleteCommand, IsRefusedWhileAnotherProcessCompletesTheSameTables) {
  ChatServer server(answer_all);
  const auto root = data("own");
  const auto lock = FolderLock::take(fs::path(root) / "data/akb/completed");
  ASSERT_TRUE(lock);
  const auto ended = run_program(command(root, server));
  EXPECT_EQ(ended.code, 2) << ended.out;
  EXPECT_THAT(ended.err, HasSubstr("process " + std::to_string(::getpid()) + " on "));
  EXPECT_EQ(server.count(), 0);
  EXPECT_THAT(completed(root), IsEmpty());
}

TEST_F(CompleteCommand, ADryRunPrintsThePromptsAndSendsNothing) {
  ChatServer server(answer_all);
  const auto root = data("own");
  const auto ended = run_program(command(root, server, {"--dry-run", "--limit", "3"}));
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("1 requests; nothing was sent"));
  EXPECT_THAT(ended.out, HasSubstr("Give aliases, function, context of each of these categories:"));
  EXPECT_EQ(server.count(), 0);
  EXPECT_THAT(completed(root), IsEmpty());
  expect_no_key(ended);
}

TEST_F(CompleteCommand, AServerThatRefusesIsQuotedWithoutTheKey) {
  ChatServer server([](const Received&) {
    return http("401 Unauthorized", std::string(R"({"error":{"message":"bad key )") + kKey + "\"}}");
  });
  const auto root = data("own");
  const auto ended = run_program(command(root, server, {"--limit", "3"}));
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.out, HasSubstr("status 401, \"bad key [key]\""));
  expect_no_key(ended);
}

TEST_F(CompleteCommand, BadInputIsRefused) {
  ChatServer server(answer_all);
  const auto root = data("own");
  const auto refused = [&](const std::vector<std::string>& more, const std::string& message) {
    const auto ended = run_program(command(root, server, more));
    EXPECT_EQ(ended.code, 2) << ended.out;
    EXPECT_THAT(ended.err, HasSubstr(message));
  };
  refused({"--batch", "0"}, "--batch");
  refused({"--limit", "-1"}, "--limit");
  const auto with = [&](const std::string& option, const std::string& value) {
    auto arguments = command(root, server);
    *(std::find(arguments.begin(), arguments.end(), option) + 1) = value;
    return run_program(arguments);
  };
  EXPECT_THAT(with("--facts", "functoin").err, HasSubstr("function"));
  EXPECT_THAT(with("--llm-url", "localhost:80").err, HasSubstr("http://"));
  EXPECT_THAT(with("--llm-model", "my model").err, HasSubstr("without spaces"));
  EXPECT_THAT(with("complete", "compleat").err, Not(IsEmpty()));
  ASSERT_TRUE(write_file(root + ".answers", std::string(2000, 'x')));
  refused({}, "cannot be used as a cache");
  EXPECT_EQ(server.count(), 0);
  EXPECT_THAT(completed(root), IsEmpty());
}

}  // namespace
}  // namespace unietp
