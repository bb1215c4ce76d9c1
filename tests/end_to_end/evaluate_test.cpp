// `unietp evaluate` as people run it: policies of the program, other programs, and models behind servers that behave
// well or badly.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/digest.h"
#include "core/files.h"
#include "core/rng.h"
#include "data_set.h"
#include "evaluation/episode_record.h"
#include "tests/llm/server.h"
#include "tests/support/thorough.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using test::ChatServer;
using test::completion;
using test::http;
using test::Received;
using ::testing::HasSubstr;
using ::testing::Not;

std::string set() { return data_set_in_all_modes().string(); }

std::vector<EpisodeRecord> episodes_in(const fs::path& folder) {
  std::vector<EpisodeRecord> episodes;
  for (const auto& json : json_lines(folder / kEpisodesFile)) {
    auto episode = read_episode("episodes.jsonl", 1, json.dump());
    EXPECT_TRUE(episode) << format(episode.error());
    if (episode) episodes.push_back(std::move(*episode));
  }
  return episodes;
}

int successes(const fs::path& folder) {
  const auto episodes = episodes_in(folder);
  return static_cast<int>(
      std::count_if(episodes.begin(), episodes.end(), [](const EpisodeRecord& one) { return one.success; }));
}

Ended evaluate(std::vector<std::string> options, const std::string& out) {
  options.insert(options.begin(), {"evaluate", set(), "--out", out});
  return run_program(options);
}
std::vector<std::string> model_at(const std::string& url) {
  return {"--model", "some-model", "--llm-url", url, "--images", "none", "--llm-wait", "0"};
}
template <class... More>
std::vector<std::string> with(std::vector<std::string> options, More... more) {
  (options.emplace_back(more), ...);
  return options;
}

/// What a model says that knows nothing: the same to the same prompt. It stops in one of four replies.
std::string said_to(const Received& request) {
  const std::string digest = sha256(request.body);
  if (digest[0] < '4') return R"({"action": "stop", "args": []})";
  if (digest[0] < '8') return "I would look around first.";
  return R"(<think>left?</think>{"action": "turn_left", "args": []})";
}
std::string calm(const Received& request) { return completion(said_to(request)); }

TEST(Evaluate, TheStoredAndTheExpertsWaySucceedAndStoppingDoesNot) {
  const ScratchFolder scratch;
  for (const char* policy : {"replay", "expert"}) {
    const auto ended = evaluate({"--policy", policy, "--modes", "M1,M2,M3"}, scratch.at(policy));
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(successes(scratch.at(policy)), 3 * kCountInAllModes) << policy;
  }
  EXPECT_EQ(evaluate({"--policy", "stop"}, scratch.at("stop")).code, 0);
  EXPECT_EQ(successes(scratch.at("stop")), 0);
  const auto again =
      evaluate({"--policy", "replay", "--modes", "M1,M2,M3", "--at-once", "1", "--limit", "2"}, scratch.at("alone"));
  EXPECT_EQ(again.code, 0) << again.err;
  const auto alone = json_lines(scratch.path() / "alone/episodes.jsonl");
  EXPECT_EQ(alone.size(), 6U);
  EXPECT_THAT(json_lines(scratch.path() / "replay/episodes.jsonl"), ::testing::IsSupersetOf(alone));
}

TEST(Evaluate, ABadServerChangesNothingThatIsRecorded) {
  const ScratchFolder scratch;
  ChatServer good(&calm);
  ASSERT_EQ(evaluate(model_at(good.url), scratch.at("good")).code, 0);
  // Each question is answered badly in all these ways first, whichever of the two episodes is faster.
  std::mutex mutex;
  std::map<std::string, int> asked;
  ChatServer bad([&](const Received& request) {
    const std::lock_guard lock(mutex);
    switch (asked[request.body]++ % 7) {
      case 0:
        return http("429 Too Many Requests", "{}", "Retry-After: 0\r\n");
      case 1:
        return http("500 Internal Server Error", "oops");
      case 2:
        return std::string("HTTP/1.1 200 OK\r\nContent-Length: 1000\r\n\r\n{\"choi");
      case 3:
        return http("200 OK", "{\"choices\": \"\xFF\xFE\"}");
      case 4:
        return http("200 OK", "[1, 2");
      case 5:
        return http("200 OK", std::string(5 << 20, ' '));
      default:
        return calm(request);
    }
  });
  const auto ended = evaluate(with(model_at(bad.url), "--llm-attempts", "7", "--at-once", "2"), scratch.at("bad"));
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(*read_file(scratch.at("bad") + "/episodes.jsonl"), *read_file(scratch.at("good") + "/episodes.jsonl"));
}

TEST(Evaluate, ASlowServerIsAskedAgainAfterTheTimeForOneAttempt) {
  const ScratchFolder scratch;
  ChatServer good(&calm);
  ASSERT_EQ(evaluate(with(model_at(good.url), "--limit", "1"), scratch.at("good")).code, 0);
  std::atomic<int> asked{0};
  ChatServer slow([&](const Received& request) {
    if (asked++ == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    return calm(request);
  });
  const auto once = with(model_at(slow.url), "--limit", "1", "--llm-timeout", "0.5");
  const auto ended = evaluate(with(once, "--llm-attempts", "2"), scratch.at("slow"));
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(asked, good.count() + 1);
  EXPECT_EQ(*read_file(scratch.at("slow") + "/episodes.jsonl"), *read_file(scratch.at("good") + "/episodes.jsonl"));
  asked = 0;
  EXPECT_EQ(evaluate(with(once, "--llm-attempts", "1"), scratch.at("once")).code, 1);
  const auto episodes = episodes_in(scratch.at("once"));
  ASSERT_EQ(episodes.size(), 1U);
  EXPECT_EQ(episodes[0].end, EpisodeOutcome::Errored);
}

TEST(Evaluate, RetryAfterToOneEpisodeHoldsBackTheOtherToo) {
  using Clock = std::chrono::steady_clock;
  const ScratchFolder scratch;
  std::mutex mutex;
  std::condition_variable changed;
  bool both_asked = false;
  std::optional<Clock::time_point> refused;
  std::vector<Clock::duration> waited;  // of the requests after the first of each episode
  ChatServer server([&](const Received& request) {
    std::unique_lock lock(mutex);
    if (request.number == 0) {
      changed.wait(lock, [&] { return both_asked; });
      refused = Clock::now();
      changed.notify_all();
      return http("429 Too Many Requests", "{}", "Retry-After: 1\r\n");
    }
    if (request.number == 1) {
      both_asked = true;
      changed.notify_all();
      changed.wait(lock, [&] { return refused.has_value(); });
      lock.unlock();
      std::this_thread::sleep_for(std::chrono::milliseconds(300));  // so that the other one knows before it goes on
      return calm(request);
    }
    waited.push_back(Clock::now() - *refused);
    return calm(request);
  });
  const auto ended = evaluate(with(model_at(server.url), "--at-once", "2"), scratch.at("run"));
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_GT(waited.size(), 2U);
  EXPECT_THAT(waited, ::testing::Each(::testing::Ge(std::chrono::seconds(1))));
}

TEST(Evaluate, ATerminalIsToldProgressRateTimeLeftAndCost) {
  const ScratchFolder scratch;
  ChatServer server([](const Received& request) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return calm(request);
  });
  std::string command = "unietp evaluate " + set() + " --out " + scratch.at("run");
  for (const std::string& option : with(model_at(server.url), "--repeats", "20", "--price-in", "5"))
    command += " " + option;
  RunningProgram program("/usr/bin/script", {"-qec", command, "/dev/null"}, scratch.at(""));
  const auto ended = program.wait();
  EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_THAT(ended.out, ::testing::ContainsRegex("[0-9]+ of [0-9]+ episodes  success [0-9]+  errored 0  [0-9.]+/s  "
                                                  "[0-9]+:[0-9][0-9] left  cost [0-9.]+"));
}

TEST(Evaluate, WhatTheModelSaysIsNotAskedAgain) {
  const ScratchFolder scratch;
  ChatServer server([](const Received&) { return completion("{\"action\": "); });
  const auto ended = evaluate(with(model_at(server.url), "--limit", "1"), scratch.at("run"));
  EXPECT_EQ(ended.code, 0) << ended.err;
  const auto episodes = episodes_in(scratch.at("run"));
  ASSERT_EQ(episodes.size(), 1U);
  EXPECT_EQ(episodes[0].end, EpisodeOutcome::Failures);
  EXPECT_EQ(episodes[0].steps.size(), 10U);
  EXPECT_EQ(server.count(), 10);
  EXPECT_NE(episodes[0].steps[0].unreadable, "");
}

TEST(Evaluate, WithoutRepliesEpisodesAreErroredAndResumed) {
  const ScratchFolder scratch;
  std::atomic<bool> broken{true};
  ChatServer server([&](const Received& request) {
    if (broken && request.number >= 5)
      return http("503 Service Unavailable", R"({"error": {"message": "overloaded"}})");
    return calm(request);
  });
  const auto options = with(model_at(server.url), "--llm-attempts", "2", "--at-once", "1");
  const auto first = evaluate(options, scratch.at("run"));
  EXPECT_EQ(first.code, 1);
  EXPECT_THAT(first.out, HasSubstr("incomplete"));
  int errored = 0;
  for (const EpisodeRecord& episode : episodes_in(scratch.at("run"))) {
    if (!episode.error) continue;
    ++errored;
    EXPECT_EQ(episode.error->kind, EpisodeErrorKind::Server);
    EXPECT_THAT(episode.error->message, HasSubstr("overloaded"));
  }
  EXPECT_GT(errored, 0);
  EXPECT_EQ(evaluate(options, scratch.at("run")).code, 2);  // not without --resume
  broken = false;
  const auto second = evaluate(with(options, "--resume"), scratch.at("run"));
  EXPECT_EQ(second.code, 0) << second.err;
  ChatServer good(&calm);
  ASSERT_EQ(evaluate(model_at(good.url), scratch.at("good")).code, 0);
  EXPECT_EQ(*read_file(scratch.at("run") + "/episodes.jsonl"), *read_file(scratch.at("good") + "/episodes.jsonl"));
  EXPECT_EQ(server.count() - 2 * errored, good.count());  // no stored reply was asked for again
}

TEST(Evaluate, AWrongKeyStopsTheRunAtOnce) {
  const ScratchFolder scratch;
  ChatServer server([](const Received&) { return http("401 Unauthorized", R"({"error": "no such key"})"); });
  const auto ended = evaluate(with(model_at(server.url), "--at-once", "1"), scratch.at("run"));
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.out, HasSubstr("no such key"));
  EXPECT_EQ(server.count(), 1);
}

/// The texts of all that a model was sent but for its own words and the system prompt, which says how many actions may
/// fail.
std::vector<std::string> messages_in(ChatServer& server) {
  std::vector<std::string> texts;
  for (const Received& request : server.received()) {
    const auto body = nlohmann::json::parse(request.body);
    for (const auto& message : body["messages"]) {
      if (message["role"] != "user") continue;
      if (message["content"].is_string()) texts.push_back(message["content"]);
      for (const auto& part : message["content"]) {
        if (part.is_object() && part["type"] == "text") texts.push_back(part["text"]);
      }
    }
  }
  return texts;
}

TEST(Evaluate, WithoutFeedbackNoPromptTellsOfSuccess) {
  const ScratchFolder scratch;
  using Options = std::vector<std::string>;
  int run = 0;
  for (const Options& talk :
       {Options{"--chat", "single"}, Options{"--chat", "multi"}, Options{"--history", "none"},
        Options{"--chat", "multi", "--history", "none"}, Options{"--images", "current"}, Options{"--prompt", "release"},
        Options{"--prompt", "release", "--history", "none"}, Options{"--prompt", "release", "--images", "current"},
        Options{"--prompt", "release", "--chat", "multi", "--box-format", "unit"}}) {
    SCOPED_TRACE(::testing::PrintToString(talk));
    ChatServer server(&calm);
    Options options{"--model", "m",        "--llm-url",  server.url, "--llm-wait", "0",
                    "--modes", "M1,M2,M3", "--feedback", "none",     "--limit",    "2"};
    options.insert(options.end(), talk.begin(), talk.end());
    if (std::find(talk.begin(), talk.end(), "--images") == talk.end())
      options.insert(options.end(), {"--images", "none"});
    const std::string out = scratch.at("run-" + std::to_string(run++));
    const auto ended = evaluate(options, out);
    ASSERT_EQ(ended.code, 0) << ended.err;
    std::set<std::string> sentences;
    int failed = 0;
    for (const EpisodeRecord& episode : episodes_in(out)) {
      for (const EpisodeStep& step : episode.steps) {
        for (const EpisodeAction& action : step.actions) {
          failed += action.success ? 0 : 1;
          if (!action.feedback.empty()) sentences.insert(action.feedback);
        }
      }
    }
    EXPECT_GT(failed, 0);
    const auto texts = messages_in(server);
    EXPECT_GT(texts.size(), 10U);
    for (const std::string& text : texts) {
      for (const char* word : {"succeed", "fail", "success", "true", "false", "Feedback"})
        ASSERT_THAT(text, Not(HasSubstr(word)));
      for (const std::string& sentence : sentences) ASSERT_THAT(text, Not(HasSubstr(sentence)));
    }
  }
}

TEST(Evaluate, EpisodesAreChosenByTheirTasks) {
  const ScratchFolder scratch;
  std::vector<std::string> all, some;
  for (const auto& task : json_lines(data_set_in_all_modes() / "tasks.jsonl")) {
    all.push_back(task["id"]);
    if (task["split"] == "compositional" && (task["simulator"] == "ai2thor" || task["simulator"] == "habitat"))
      some.push_back(task["id"]);
  }
  const auto played = [&](std::vector<std::string> options, const std::string& out) {
    options.insert(options.end(), {"--policy", "stop"});
    EXPECT_EQ(evaluate(options, scratch.at(out)).code, 0);
    std::vector<std::string> ids;
    for (const EpisodeRecord& one : episodes_in(scratch.at(out))) ids.push_back(one.key.task);
    return ids;
  };
  ASSERT_FALSE(some.empty());
  EXPECT_EQ(played({"--splits", "compositional", "--simulators", "ai2thor,habitat"}, "some"), some);
  EXPECT_EQ(played({"--limit", "3"}, "first"), (std::vector<std::string>{all[0], all[1], all[2]}));
  EXPECT_EQ(played({"--tasks", all[5] + "," + all[1]}, "named"), (std::vector<std::string>{all[1], all[5]}));
  EXPECT_EQ(evaluate({"--policy", "stop", "--tasks", "no-such-task"}, scratch.at("none")).code, 2);
}

TEST(Evaluate, AChangedSettingIsNotResumed) {
  const ScratchFolder scratch;
  ASSERT_EQ(evaluate({"--policy", "stop"}, scratch.at("run")).code, 0);
  const auto ended = evaluate({"--policy", "stop", "--resume", "--setting", "steps=20"}, scratch.at("run"));
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("settings.M1.steps: 50 then, 20 now"));
}

TEST(Evaluate, AnotherPromptDataSetOrProgramIsNotResumed) {
  const ScratchFolder scratch;
  const fs::path prompt = scratch.path() / "own.prompt", run = scratch.at("run"), data = scratch.at("data");
  fs::copy(data_set_in_all_modes(), data, fs::copy_options::recursive);
  ASSERT_TRUE(write_file(prompt, "[turn]\n{{task}}\n{{view}}\n"));
  ChatServer server(&calm);
  const auto evaluate_again = [&](const std::vector<std::string>& more) {
    auto options = with(model_at(server.url), "--limit", "1", "--prompt", prompt.string());
    options.insert(options.begin(), {"evaluate", data.string(), "--out", run.string()});
    options.insert(options.end(), more.begin(), more.end());
    return run_program(options);
  };
  ASSERT_EQ(evaluate_again({}).code, 0);
  ASSERT_EQ(evaluate_again({"--resume"}).code, 0) << "nothing has changed";
  const int asked = server.count();
  const auto refused = [&](const std::string& what) {
    const Ended ended = evaluate_again({"--resume"});
    EXPECT_EQ(ended.code, 2) << what;
    EXPECT_THAT(ended.err, HasSubstr(what));
    EXPECT_EQ(server.count(), asked);
  };

  ASSERT_TRUE(write_file(prompt, "[turn]\n{{task}}\n{{view}} \n"));
  refused("talk.prompt_digest: ");
  ASSERT_TRUE(write_file(prompt, "[turn]\n{{task}}\n{{view}}\n"));

  const std::string tasks = *read_file(data / "tasks.jsonl");
  const std::string text = R"("instruction":{"text":")";
  ASSERT_NE(tasks.find(text), std::string::npos);
  ASSERT_TRUE(write_file(data / "tasks.jsonl", std::string(tasks).insert(tasks.find(text) + text.size(), "Now ")));
  refused("dataset.digest: ");
  ASSERT_TRUE(write_file(data / "tasks.jsonl", tasks));

  auto manifest = nlohmann::ordered_json::parse(*read_file(run / "manifest.json"));
  manifest["setup"]["program"]["build"] = std::string(64, '0');
  ASSERT_TRUE(write_file(run / "manifest.json", manifest.dump(2) + "\n"));
  refused("program.build: ");
}

TEST(Evaluate, ProgramsActAndTheirEndIsNoFailureOfTheTask) {
  const ScratchFolder scratch;
  ASSERT_TRUE(write_file(scratch.path() / "agent.py",
                         "class Agent:\n"
                         "    def begin(self, episode): self.left = 2\n"
                         "    def act(self, observation):\n"
                         "        print('thinking aloud')\n"
                         "        self.left -= 1\n"
                         "        return {'action': 'turn_left', 'args': []} if self.left >= 0 else 'stop'\n"
                         "class Broken:\n"
                         "    def __init__(self): open('starts', 'a').write('x')\n"
                         "    def act(self, observation): raise SystemExit(3)\n"));
  const auto run = [&](const std::string& policy, const std::string& out) {
    RunningProgram program("/bin/sh",
                           {"-c", "exec unietp \"$@\"", "unietp", "evaluate", set(), "--policy", policy, "--limit", "2",
                            "--out", scratch.at(out), "--llm-wait", "0.01"},
                           scratch.path());
    return program.wait();
  };
  const auto good = run("python:agent.Agent", "good");
  EXPECT_EQ(good.code, 0) << good.err;
  for (const EpisodeRecord& episode : episodes_in(scratch.at("good"))) {
    EXPECT_EQ(episode.end, EpisodeOutcome::Stop);
    EXPECT_EQ(episode.steps.size(), 3U);
  }
  const auto broken = run("python:agent.Broken", "broken");
  EXPECT_EQ(broken.code, 1) << broken.err;
  for (const EpisodeRecord& episode : episodes_in(scratch.at("broken"))) {
    ASSERT_TRUE(episode.error);
    EXPECT_EQ(episode.error->kind, EpisodeErrorKind::Policy);
    EXPECT_THAT(episode.error->message, HasSubstr("exit code 3"));
  }
  EXPECT_EQ(*read_file(scratch.path() / "starts"), "xxxxxx") << "three times for each of two episodes";
  const auto nothing = run("randon", "none");
  EXPECT_EQ(nothing.code, 2);
  EXPECT_THAT(nothing.err, HasSubstr("there is no program \"randon\"; did you mean random?"));
  EXPECT_FALSE(fs::exists(scratch.at("none")));
}

TEST(Evaluate, ProgramsGetPicturesUnlessNoneAreAskedFor) {
  const ScratchFolder scratch;
  ASSERT_TRUE(write_file(scratch.path() / "agent.py",
                         "class Agent:\n"
                         "    def act(self, observation):\n"
                         "        open('seen', 'a').write('picture ' if 'picture' in observation else 'words ')\n"
                         "        return 'stop'\n"));
  for (const std::string images : {"current", "none"}) {
    RunningProgram program("/bin/sh",
                           {"-c", "exec unietp \"$@\"", "unietp", "evaluate", set(), "--policy", "python:agent.Agent",
                            "--modes", "M3", "--limit", "1", "--images", images, "--out", scratch.at(images)},
                           scratch.path());
    const Ended ended = program.wait();
    EXPECT_EQ(ended.code, 0) << ended.err;
  }
  EXPECT_EQ(*read_file(scratch.path() / "seen"), "picture words ");
}

TEST(Evaluate, AnInterruptEndsItWithinTwoSeconds) {
  const ScratchFolder scratch;
  ChatServer server([](const Received&) { return ChatServer::kSilence; });
  auto options = model_at(server.url);
  options.insert(options.begin(), {"evaluate", set(), "--out", scratch.at("run")});
  RunningProgram program(options);
  for (int i = 0; i < 500 && server.count() == 0; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  ASSERT_GT(server.count(), 0);
  const auto begin = std::chrono::steady_clock::now();
  program.send(SIGTERM);
  EXPECT_EQ(program.wait().code, 130);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(2));
}

TEST(EvaluateKilled, AtRandomPointsItEndsWithTheSameBytes) {
  const int wanted = test::tries(15, 100);
  const ScratchFolder scratch;
  ChatServer good(&calm);
  ASSERT_EQ(evaluate(with(model_at(good.url), "--repeats", "3"), scratch.at("good")).code, 0);
  ChatServer slow([](const Received& request) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return calm(request);
  });
  auto options = with(model_at(slow.url), "--repeats", "3", "--resume", "--at-once", "2");
  Rng rng(27);
  int kills = 0;
  for (int run = 0; kills < wanted; ++run) {
    const std::string out = scratch.at("run" + std::to_string(run));
    auto arguments = options;
    arguments.insert(arguments.begin(), {"evaluate", set(), "--out", out});
    for (bool done = false; !done;) {
      RunningProgram program(arguments);
      if (kills < wanted) {
        std::this_thread::sleep_for(std::chrono::milliseconds(150 + rng.below(500)));
        program.send(SIGKILL);
      }
      const auto ended = program.wait();
      kills += ended.signal == SIGKILL ? 1 : 0;
      done = ended.code == 0;
      ASSERT_TRUE(done || ended.signal == SIGKILL) << ended.err;
    }
    ASSERT_EQ(*read_file(out + "/episodes.jsonl"), *read_file(scratch.at("good") + "/episodes.jsonl")) << run;
  }
}

}  // namespace
}  // namespace unietp
