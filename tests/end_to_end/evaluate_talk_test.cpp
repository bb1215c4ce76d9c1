// What `unietp evaluate` asks a server for by its options, and what becomes of it.
#include <algorithm>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "data_set.h"
#include "evaluation/episode_log.h"
#include "evaluation/episode_record.h"
#include "schema_checker.h"
#include "tests/llm/server.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using test::ChatServer;
using test::completion;
using test::Received;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Each;
using ::testing::Ge;
using ::testing::HasSubstr;

constexpr const char* kTurn = R"({"action": "turn_left", "args": []})";
constexpr const char* kStop = R"({"action": "stop", "args": []})";

/// Runs a model on the first task, or as many as `more` says.
Ended evaluate(const std::string& url, const std::string& out, std::vector<std::string> more) {
  std::vector<std::string> options{"evaluate",   data_set_in_all_modes().string(),
                                   "--out",      out,
                                   "--model",    "some-model",
                                   "--llm-url",  url,
                                   "--llm-wait", "0",
                                   "--at-once",  "1"};
  if (std::find(more.begin(), more.end(), "--limit") == more.end()) more.insert(more.end(), {"--limit", "1"});
  options.insert(options.end(), more.begin(), more.end());
  return run_program(options);
}

/// Turns left `turns` times in each episode, then stops; an episode is known by its history.
std::string turns_then_stops(const Received& request, int turns) {
  int done = 0;
  for (auto at = request.user.find("turn_left"); at != std::string::npos; at = request.user.find("turn_left", at + 1))
    ++done;
  return completion(done < turns ? kTurn : kStop);
}

std::vector<Json> bodies(ChatServer& server) {
  std::vector<Json> all;
  for (const Received& one : server.received()) all.push_back(Json::parse(one.body));
  return all;
}

TEST(EvaluateTalk, ALongReplyIsWholeInTheLogAndCutInTheEpisode) {
  const ScratchFolder scratch;
  const std::string thought(3'000'000, 't'), said = std::string(40'000, 'x') + kStop;
  ChatServer server([&](const Received& request) {
    return request.number == 0 ? completion("<think>" + thought + "</think>" + said) : completion(kStop);
  });
  const Ended ended = evaluate(server.url, scratch.at("run"), {});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto logged = json_lines(fs::path(scratch.at("run")) / kEpisodeLog);
  ASSERT_FALSE(logged.empty());
  EXPECT_EQ(logged.front().at("reply"), said);
  EXPECT_EQ(logged.front().at("thinking"), thought);
  const auto step = json_lines(fs::path(scratch.at("run")) / kEpisodesFile).front().at("steps").front();
  const auto reply = step.at("reply").get<std::string>(), thinking = step.at("thinking").get<std::string>();
  EXPECT_LT(reply.size(), 33'000U);
  EXPECT_LE(thinking.size(), 2U << 20);
  EXPECT_EQ(reply, said.substr(0, reply.size()));
  EXPECT_EQ(thinking, thought.substr(0, thinking.size()));
}

TEST(EvaluateTalk, StructuredRepliesAreAskedForByASchemaThatTheyKeep) {
  const ScratchFolder scratch;
  ChatServer server([](const Received&) { return completion(kStop); });
  ASSERT_EQ(evaluate(server.url, scratch.at("plain"), {"--images", "none"}).code, 0);
  EXPECT_FALSE(bodies(server).front().contains("response_format"));
  ASSERT_EQ(evaluate(server.url, scratch.at("asked"), {"--images", "none", "--structured", "--reasoning"}).code, 0);
  const Json format = bodies(server).back()["response_format"];
  EXPECT_EQ(format["type"], "json_schema");
  const Json schema = format["json_schema"]["schema"];
  EXPECT_EQ(schema["required"], Json({"reasoning", "action", "args"}));
  const std::vector<std::string> names = schema["properties"]["action"]["enum"];
  EXPECT_THAT(names, AllOf(Contains("go_to"), Contains("stop"), Contains("turn_left")));
  EXPECT_EQ(schema["properties"]["args"]["items"]["type"], "string") << "M1 names objects by ids alone";
  ASSERT_EQ(evaluate(server.url, scratch.at("boxes"), {"--images", "none", "--structured", "--modes", "M3"}).code, 0);
  const Json argument =
      bodies(server).back()["response_format"]["json_schema"]["schema"]["properties"]["args"]["items"];
  ASSERT_TRUE(argument.contains("anyOf")) << argument;
  EXPECT_TRUE(argument["anyOf"][1]["properties"].contains("bbox"));
}

TEST(EvaluateTalk, NoReplyIsAskedForAboveTheCostThatIsAllowed) {
  const ScratchFolder scratch;
  ChatServer server([](const Received& request) { return turns_then_stops(request, 3); });
  // 11 tokens in and 7 out: 0.018 a reply, so three replies are below 0.05 and the third is the last.
  const std::vector<std::string> priced{"--images",    "none", "--price-in", "1000",
                                        "--price-out", "1000", "--limit",    "4"};
  auto capped = priced;
  capped.insert(capped.end(), {"--max-cost", "0.05"});
  const Ended stopped = evaluate(server.url, scratch.at("run"), capped);
  EXPECT_EQ(stopped.code, 1);
  EXPECT_THAT(stopped.out, AllOf(HasSubstr("--max-cost"), HasSubstr("incomplete")));
  EXPECT_EQ(server.count(), 3);
  auto rest = priced;
  rest.emplace_back("--resume");
  const Ended ended = evaluate(server.url, scratch.at("run"), rest);
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(server.count(), 16) << "no reply was paid twice";
  const Json manifest = Json::parse(*read_file(fs::path(scratch.at("run")) / "manifest.json"));
  EXPECT_NEAR(manifest["totals"]["cost"].get<double>(), 16 * 0.018, 1e-9);
}

TEST(EvaluateTalk, ACacheSharesRepliesBetweenRunsAndNotBetweenRepeats) {
  const ScratchFolder scratch;
  ChatServer server([](const Received& request) { return turns_then_stops(request, 2); });
  const std::vector<std::string> cached{"--images", "none", "--repeats", "2", "--cache", scratch.at("replies.sqlite")};
  ASSERT_EQ(evaluate(server.url, scratch.at("first"), cached).code, 0);
  EXPECT_EQ(server.count(), 6) << "three replies for each repeat";
  ASSERT_EQ(evaluate(server.url, scratch.at("second"), cached).code, 0);
  EXPECT_EQ(server.count(), 6) << "all are in the cache";
  EXPECT_EQ(*read_file(scratch.at("first") + "/episodes.jsonl"), *read_file(scratch.at("second") + "/episodes.jsonl"));
}

/// How many pictures each of the user's turns has.
std::vector<int> pictures_in(const Json& body) {
  std::vector<int> counts;
  for (const Json& message : body["messages"]) {
    if (message["role"] != "user") continue;
    counts.push_back(0);
    if (!message["content"].is_array()) continue;
    for (const Json& part : message["content"]) counts.back() += part["type"] == "image_url" ? 1 : 0;
  }
  return counts;
}

TEST(EvaluateTalk, AsManyPicturesAreSentAsAreAskedFor) {
  const ScratchFolder scratch;
  using Counts = std::vector<int>;
  const auto sent = [&](const std::string& images, const std::string& chat) {
    int asked = 0;
    ChatServer server([&](const Received&) { return completion(++asked < 4 ? kTurn : kStop); });
    const Ended ended = evaluate(server.url, scratch.at(images + chat), {"--images", images, "--chat", chat});
    EXPECT_EQ(ended.code, 0) << ended.err;
    std::vector<Counts> all;
    for (const Json& body : bodies(server)) all.push_back(pictures_in(body));
    return all;
  };
  EXPECT_EQ(sent("none", "single"), (std::vector<Counts>{{0}, {0}, {0}, {0}}));
  EXPECT_EQ(sent("current", "single"), (std::vector<Counts>{{1}, {1}, {1}, {1}}));
  EXPECT_EQ(sent("2", "single"), (std::vector<Counts>{{1}, {2}, {2}, {2}}));
  EXPECT_EQ(sent("2", "multi"), (std::vector<Counts>{{1}, {1, 1}, {0, 1, 1}, {0, 0, 1, 1}}));
}

/// The numbers of the boxes in the first turns of an evaluation with these options.
std::vector<double> boxes_shown(const std::vector<std::string>& options) {
  const ScratchFolder scratch;
  ChatServer server([](const Received&) { return completion(kStop); });
  auto all = options;
  all.insert(all.end(), {"--images", "none", "--limit", "4"});  // the first may see nothing at first
  const Ended ended = evaluate(server.url, scratch.at("run"), all);
  EXPECT_EQ(ended.code, 0) << ended.err;
  std::vector<double> numbers;
  for (const Json& body : bodies(server)) {
    const std::string text = body["messages"].back()["content"];
    const std::string view = text.substr(std::min(text.find("In view:"), text.size()));
    for (auto at = view.find('['); at != std::string::npos; at = view.find('[', at + 1)) {
      for (const double number : Json::parse(view.substr(at, view.find(']', at) + 1 - at))) numbers.push_back(number);
    }
  }
  return numbers;
}

TEST(EvaluateTalk, BoxesAreToldInTheFormThatIsAskedForOrNotAtAll) {
  const auto pixels = boxes_shown({}), unit = boxes_shown({"--box-format", "unit"}),
             thousand = boxes_shown({"--box-format", "thousand"}),
             y_first = boxes_shown({"--box-format", "thousand_y_first"});
  ASSERT_GE(pixels.size(), 4U);
  ASSERT_EQ(unit.size(), pixels.size());
  ASSERT_EQ(thousand.size(), pixels.size());
  ASSERT_EQ(y_first.size(), pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    EXPECT_LE(unit[i], 1);
    EXPECT_NEAR(thousand[i], 1000 * unit[i], 1e-9);
    EXPECT_EQ(y_first[i ^ 1], thousand[i]);
  }
  EXPECT_NE(pixels, thousand);
  EXPECT_TRUE(boxes_shown({"--boxes", "off"}).empty());
}

TEST(EvaluateTalk, TheReleasedRunnersPromptAsksInItsForm) {
  const ScratchFolder scratch;
  ChatServer server([](const Received& request) {
    const bool began = request.user.find("Action success: ") != std::string::npos;
    return completion(began ? R"({"reasoning": "there", "actions": [{"action_name": "done", "args": {}}]})"
                            : R"({"reasoning": "look", "actions": [{"action_name": "turn left", "args": {}},
                                  {"action_name": "turn right", "args": {}}]})");
  });
  const Ended ended =
      evaluate(server.url, scratch.at("run"), {"--images", "none", "--prompt", "release", "--preset", "release"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Json first = bodies(server).front()["messages"], second = bodies(server).back()["messages"];
  EXPECT_THAT(first[0]["content"].get<std::string>(), HasSubstr("\"action_name\": \"NAME\""));
  EXPECT_THAT(first[1]["content"].get<std::string>(),
              AllOf(HasSubstr("Rooms in the scene: ["), HasSubstr("Objects currently in view: ")));
  EXPECT_THAT(second[1]["content"].get<std::string>(),
              HasSubstr("1. turn left. Action success: true\n2. turn right. Action success: true"));
  const Json episode = json_lines(fs::path(scratch.at("run")) / "episodes.jsonl").front();
  std::vector<std::string> done;
  for (const Json& step : episode["steps"]) {
    EXPECT_EQ(step["unreadable"], "");
    for (const Json& action : step["actions"]) done.push_back(action["action"]);
  }
  EXPECT_EQ(done, (std::vector<std::string>{"turn_left", "turn_right", "stop"}));
  EXPECT_EQ(episode["end"], "stop");
}

TEST(EvaluateTalk, AServerThatHangsIsGivenUpAfterItsTime) {
  const ScratchFolder scratch;
  ChatServer server([](const Received&) { return ChatServer::kSilence; });
  const Ended ended = evaluate(server.url, scratch.at("run"),
                               {"--images", "none", "--llm-timeout", "0.2", "--llm-attempts", "2", "--limit", "2"});
  EXPECT_EQ(ended.code, 1) << ended.err;
  EXPECT_EQ(server.count(), 4);
  const auto episodes = json_lines(fs::path(scratch.at("run")) / "episodes.jsonl");
  ASSERT_EQ(episodes.size(), 2U);
  for (const Json& episode : episodes) {
    EXPECT_EQ(episode["error"]["kind"], "timeout");
    EXPECT_EQ(episode["success"], false);
  }
  for (const Json& timing : json_lines(fs::path(scratch.at("run")) / "timing.jsonl"))
    EXPECT_EQ(timing["error_attempts"], 2);
  const std::string table = *read_file(fs::path(scratch.at("run")) / "tables.md");
  EXPECT_THAT(table, AllOf(HasSubstr("Incomplete"), HasSubstr("2 errored")));
}

TEST(EvaluateTalk, ThePromptThatIsPrintedIsTheOneThatIsSent) {
  const ScratchFolder scratch;
  ChatServer server([](const Received& request) { return turns_then_stops(request, 3); });
  const std::vector<std::string> talk{"--images", "none", "--reasoning"};
  auto dry = talk;
  dry.emplace_back("--dry-run");
  const Ended planned = evaluate(server.url, scratch.at("run"), dry);
  EXPECT_EQ(planned.code, 0) << planned.err;
  EXPECT_EQ(server.count(), 0);
  EXPECT_FALSE(fs::exists(scratch.at("run")));
  ASSERT_EQ(evaluate(server.url, scratch.at("run"), talk).code, 0);
  const auto sent = bodies(server);
  ASSERT_EQ(sent.size(), 4U);
  EXPECT_THAT(planned.out, HasSubstr(sent[0]["messages"][1]["content"].get<std::string>()));
  auto third = talk;
  const Json episode = json_lines(fs::path(scratch.at("run")) / "episodes.jsonl").front();
  third.insert(third.end(), {"--show-prompt", episode["task"].get<std::string>() + ":3"});
  const Ended shown = evaluate(server.url, scratch.at("run"), third);
  EXPECT_EQ(shown.code, 0) << shown.err;
  for (const Json& message : sent[2]["messages"])
    EXPECT_THAT(shown.out, HasSubstr(message["content"].get<std::string>()));
  EXPECT_EQ(server.count(), 4);
}

TEST(EvaluateTalk, OnlyTheModesThatAreNamedArePlayedAndPrinted) {
  const ScratchFolder scratch;
  ChatServer server([](const Received& request) { return turns_then_stops(request, 2); });
  const std::vector<std::string> talk{"--images", "none", "--modes", "M3"};
  ASSERT_EQ(evaluate(server.url, scratch.at("run"), talk).code, 0);
  const auto episodes = json_lines(fs::path(scratch.at("run")) / "episodes.jsonl");
  ASSERT_EQ(episodes.size(), 1U);
  EXPECT_EQ(episodes[0]["mode"], "M3");
  auto second = talk;
  second.insert(second.end(), {"--show-prompt", episodes[0]["task"].get<std::string>() + ":2"});
  const Ended shown = evaluate(server.url, scratch.at("run"), second);
  EXPECT_EQ(shown.code, 0) << shown.err;
  const auto sent = bodies(server);
  ASSERT_EQ(sent.size(), 3U);
  for (const Json& message : sent[1]["messages"])
    EXPECT_THAT(shown.out, HasSubstr(message["content"].get<std::string>()));

  second[3] = "M2,M3";
  const Ended unclear = evaluate(server.url, scratch.at("run"), second);
  EXPECT_EQ(unclear.code, 2);
  EXPECT_THAT(unclear.err, HasSubstr("name the mode"));
}

TEST(EvaluateTalk, TheRequestHasTheFieldsThatAreAskedFor) {
  const ScratchFolder scratch;
  ChatServer server([](const Received&) { return completion("<think>it is done</think>" + std::string(kStop)); });
  ASSERT_EQ(evaluate(server.url, scratch.at("run"),
                     {"--images", "none", "--temperature", "0.5", "--top-p", "0.9", "--max-tokens", "77",
                      "--sampling-seed", "5", "--repeats", "2", "--extra", R"({"min_p": 0.1})"})
                .code,
            0);
  const auto sent = bodies(server);
  ASSERT_EQ(sent.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(sent[i]["temperature"], 0.5);
    EXPECT_EQ(sent[i]["top_p"], 0.9);
    EXPECT_EQ(sent[i]["max_tokens"], 77);
    EXPECT_EQ(sent[i]["seed"], 5 + i) << "each repeat has a seed of its own";
    EXPECT_EQ(sent[i]["min_p"], 0.1);
  }
  for (const Json& episode : json_lines(fs::path(scratch.at("run")) / "episodes.jsonl")) {
    EXPECT_EQ(episode["steps"][0]["thinking"], "it is done");
    EXPECT_EQ(episode["steps"][0]["reply"], kStop);
    EXPECT_EQ(episode["end"], "stop");
  }
}

TEST(EvaluateTalk, AsManyStepsAreToldAgainAsAreAskedFor) {
  const ScratchFolder scratch;
  const auto steps_shown = [&](const std::string& history) {
    int asked = 0;
    ChatServer server([&](const Received&) { return completion(++asked < 5 ? kTurn : kStop); });
    EXPECT_EQ(evaluate(server.url, scratch.at(history), {"--images", "none", "--history", history}).code, 0);
    const std::string user = server.received().back().user;
    int count = 0;
    for (auto at = user.find("turn_left"); at != std::string::npos; at = user.find("turn_left", at + 1)) ++count;
    return count;
  };
  EXPECT_EQ(steps_shown("full"), 4);
  for (const char* history : {"1001", "-1", "some"})
    EXPECT_EQ(evaluate("http://127.0.0.1:9", scratch.at("refused"), {"--images", "none", "--history", history}).code,
              2);
  EXPECT_EQ(steps_shown("2"), 2);
  EXPECT_EQ(steps_shown("none"), 0) << "only what became of the last action, without its name";
}

TEST(EvaluateTalk, EveryLineOfTheLogIsOfASchema) {
  const ScratchFolder scratch;
  ChatServer server([](const Received& request) { return turns_then_stops(request, 1); });
  ASSERT_EQ(evaluate(server.url, scratch.at("run"), {"--images", "none", "--limit", "3"}).code, 0);
  SchemaChecker checker;
  std::map<std::string, int> lines;
  for (const Json& line : json_lines(fs::path(scratch.at("run")) / kEpisodeLog)) {
    const std::string format = line["format"];
    const std::string kind = format.substr(7, format.find('/') - 7);  // "reply" of "unietp-reply/1"
    ++lines[kind];
    EXPECT_EQ(checker.check(line, kind + ".schema.json"), "");
  }
  EXPECT_EQ(lines, (std::map<std::string, int>{{"episode", 3}, {"reply", 6}, {"timing", 3}}));
}

}  // namespace
}  // namespace unietp
