// `unietp serve` as clients use it: over stdio, HTTP and WebSocket, by programs and by strangers.
#include <pwd.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../serve/client.h"
#include "core/files.h"
#include "core/text.h"
#include "data_set.h"
#include "served.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using test::ask;
using test::WebSocketClient;
using ::testing::HasSubstr;
using ::testing::Not;

std::vector<std::string> request_lines(const std::vector<ServedCall>& calls) {
  std::vector<std::string> lines;
  for (const auto& call : calls) lines.push_back(request_line(static_cast<int>(lines.size()), call));
  return lines;
}

Json with_session(Json parameters, const std::string& session) {
  parameters["session"] = session;
  return parameters;
}

/// What no client may learn of the machine.
void expect_no_place(const std::string& answer) {
  const char* home = std::getenv("HOME");
  const passwd* user = ::getpwuid(::getuid());
  for (const std::string& secret :
       {data_set_in_all_modes().parent_path().string(), std::string(UNIETP_SOURCE_DIR "/build"),
        std::string(home == nullptr ? "/home/" : home) + "/", std::string("/home/"),
        "\"" + std::string(user == nullptr ? "nobody" : user->pw_name) + "\""}) {
    EXPECT_EQ(answer.find(secret), std::string::npos) << secret << " is in " << answer.substr(0, 2000);
  }
}

TEST(ServeStdio, EachDemonstrationReachesItsGoalInEachModeWithTheStoredOutcomes) {
  int replayed = 0;
  for (const std::string mode : {"M1", "M2", "M3"}) {
    const auto shown = json_lines(data_set_in_all_modes() / "demonstrations" / (mode + ".jsonl"));
    for (std::size_t i = 0; i < shown.size(); ++i) {
      SCOPED_TRACE(mode + " " + shown[i]["task"].get<std::string>());
      const auto answers =
          served_lines(data_set_in_all_modes(), request_lines(demonstrated_calls(data_set_in_all_modes(), mode, i)));
      const auto& steps = shown[i]["steps"];
      ASSERT_EQ(answers.size(), steps.size() + 2);
      for (std::size_t k = 0; k < steps.size(); ++k) {
        const auto result = Json::parse(answers[k + 2])["result"];
        EXPECT_EQ(result["observation"]["last"]["success"], steps[k]["success"]);
        EXPECT_EQ(result["observation"]["last"].value("feedback", ""), steps[k]["feedback"]);
        EXPECT_EQ(result["terminated"], k + 1 == steps.size());
        EXPECT_EQ(result["reward"], k + 1 == steps.size() ? 1.0 : 0.0);
      }
      for (const auto& answer : answers) expect_no_place(answer);
      ++replayed;
    }
  }
  EXPECT_EQ(replayed, 3 * kCountInAllModes);
}

TEST(ServeStdio, TwoSessionsThatTakeTurnsAreAnsweredLikeEachAlone) {
  const fs::path& set = data_set_in_all_modes();
  const auto one = demonstrated_calls(set, "M1", 0), two = demonstrated_calls(set, "M3", 1);
  const auto alone_one = served_lines(set, request_lines(one)), alone_two = served_lines(set, request_lines(two));
  std::vector<std::string> both;
  for (std::size_t i = 0; i < std::max(one.size(), two.size()); ++i) {
    const auto line = [&](const ServedCall& call, const std::string& session) {
      both.push_back(request_line(static_cast<int>(i),
                                  {call.method, i == 0 ? call.parameters : with_session(call.parameters, session)}));
    };
    if (i < one.size()) line(one[i], "1");
    if (i < two.size()) line(two[i], "2");
  }
  const auto answers = served_lines(set, both);
  std::size_t at = 0;
  for (std::size_t i = 0; i < std::max(one.size(), two.size()); ++i) {
    if (i < one.size()) {
      EXPECT_EQ(answers.at(at++), alone_one.at(i));
    }
    if (i < two.size() && i == 0) ++at;  // its token is another
    if (i < two.size() && i > 0) {
      EXPECT_EQ(answers.at(at++), alone_two.at(i));
    }
  }
  EXPECT_EQ(at, answers.size());
}

TEST(ServeStdio, EachMalformedLineIsAnsweredAndTheNextIsServed) {
  std::vector<std::string> lines{"", "{", "[]", "\xff\xfe", std::string(3 << 20, 'x'), std::string(200'000, '[')};
  const std::size_t bad = lines.size();
  lines.push_back(request_line(7, {"hello"}));
  const auto answers = served_lines(data_set_in_all_modes(), lines);
  ASSERT_EQ(answers.size(), lines.size());
  for (std::size_t i = 0; i < bad; ++i) {
    EXPECT_TRUE(Json::parse(answers[i]).contains("error")) << answers[i];
    expect_no_place(answers[i]);
  }
  EXPECT_EQ(Json::parse(answers.back())["result"]["tasks"], kCountInAllModes);
  EXPECT_EQ(Json::parse(answers.back())["result"]["demonstrated"], Json({"M1", "M2", "M3"}));
}

TEST(ServeStdio, TasksAreNamedByIdIndexOrSeedAndNeverByPath) {
  const auto tasks = json_lines(data_set_in_all_modes() / "tasks.jsonl");
  std::vector<ServedCall> calls{{"open"}, {"reset", {{"index", 2}}}, {"tasks", {{"from", 1}, {"count", 2}}}};
  for (int episode = 0; episode < kCountInAllModes; ++episode)
    calls.push_back({"reset", {{"seed", 5}, {"episode", episode}}});
  const std::size_t good = calls.size();
  for (const Json& wrong :
       {Json("../../etc/passwd"), Json("/etc/passwd"), Json("tasks.jsonl"), Json(""), Json(std::string(100'000, 'x'))})
    calls.push_back({"reset", {{"task", wrong}}});
  calls.push_back({"reset", {{"index", kCountInAllModes}}});
  const auto answers = served_lines(data_set_in_all_modes(), request_lines(calls));
  EXPECT_EQ(Json::parse(answers[1])["result"]["task"], tasks[2]["id"]);
  const auto listed = Json::parse(answers[2])["result"];
  EXPECT_EQ(listed["total"], kCountInAllModes);
  EXPECT_EQ(listed["tasks"].size(), 2U);
  EXPECT_EQ(listed["tasks"][0]["task"], tasks[1]["id"]);
  EXPECT_EQ(listed["tasks"][0]["instruction"], tasks[1]["instruction"]["text"]);
  std::set<std::string> played;
  for (std::size_t i = 3; i < good; ++i) played.insert(Json::parse(answers[i])["result"]["task"].get<std::string>());
  EXPECT_EQ(played.size(), static_cast<std::size_t>(kCountInAllModes));
  for (std::size_t i = good; i < answers.size(); ++i) {
    EXPECT_TRUE(Json::parse(answers[i]).contains("error")) << answers[i];
    expect_no_place(answers[i]);
  }
}

TEST(ServeStdio, AStrangersDataSetIsRefusedOrItsFaultsAreKeptFromTheAnswers) {
  const ScratchFolder scratch;
  const fs::path set = scratch.path() / "set";
  fs::copy(data_set_in_all_modes(), set, fs::copy_options::recursive);
  auto tasks = json_lines(set / "tasks.jsonl");
  const auto write = [&] {
    std::string lines;
    for (const auto& task : tasks) lines += task.dump() + "\n";
    ASSERT_TRUE(write_file(set / "tasks.jsonl", lines));
  };
  const std::string layout = tasks[0]["layout"];
  fs::remove(set / "homes" / (layout + ".scene.json.gz"));
  const auto answers = served_lines(set, request_lines({{"open"}, {"reset", {{"index", 0}}}}), "2> errors");
  EXPECT_EQ(Json::parse(answers[1])["error"]["code"], -32004);
  EXPECT_THAT(answers[1], Not(HasSubstr(layout)));
  EXPECT_THAT(answers[1], Not(HasSubstr(scratch.path().string())));
  tasks[0]["id"] = "../../../../etc/passwd";
  write();
  const auto ended = run_program({"serve", set.string()});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("tasks.jsonl:1"));
}

TEST(ServeStdio, EndsWithinTwoSecondsOfASignal) {
  LongCommand server("serve '" + data_set_in_all_modes().string() + "'");
  server.write(request_line(1, {"hello"}) + "\n");
  server.until_printed("\"result\"");
  const auto before = std::chrono::steady_clock::now();
  server.send(SIGTERM);
  EXPECT_EQ(server.wait().code, 130);
  EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(2));
}

/// A server at a port, which is ended as its users end it.
class ServePort : public ::testing::Test {
 protected:
  explicit ServePort(const std::string& options = "")
      : server("serve '" + data_set_in_all_modes().string() + "' --port 0 " + options), url(server.url()) {}
  ~ServePort() override {
    const auto before = std::chrono::steady_clock::now();
    server.send(SIGTERM);
    EXPECT_EQ(server.wait().code, 130);
    EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(2));
  }
  test::HttpReply post(const ServedCall& call) {
    auto reply = ask(url, "POST", "/v1/" + call.method, call.parameters.dump());
    expect_no_place(reply.body);
    return reply;
  }
  Json result(const ServedCall& call) {
    auto reply = post(call);
    EXPECT_EQ(reply.status, 200) << reply.body;
    EXPECT_EQ(reply.headers["Content-Type"], "application/json; charset=utf-8");
    return Json::parse(reply.body);
  }

  LongCommand server;
  std::string url;
};

TEST_F(ServePort, OverHttpADemonstrationReachesItsGoalAndSessionsAreTheirTokens) {
  auto calls = demonstrated_calls(data_set_in_all_modes(), "M2", 1);
  const std::string session = result(calls[0])["session"];
  EXPECT_EQ(session.size(), 32U);
  Json last;
  for (std::size_t i = 1; i < calls.size(); ++i)
    last = result({calls[i].method, with_session(calls[i].parameters, session)});
  EXPECT_EQ(last["reward"], 1.0);
  EXPECT_EQ(post({"observe"}).status, 400);
  EXPECT_EQ(post({"observe", {{"session", "1"}}}).status, 404);
  EXPECT_EQ(post({"state", {{"session", session}}}).status, 403);
  EXPECT_EQ(post({"dance"}).status, 404);
  EXPECT_EQ(ask(url, "GET", "/v1/hello").status, 405);
  EXPECT_EQ(ask(url, "GET", "/etc/passwd").status, 404);
  EXPECT_EQ(ask(url, "GET", "/../../etc/passwd").status, 404);
  EXPECT_EQ(ask(url, "POST", "/v1/hello", "nonsense").status, 400);
  EXPECT_EQ(ask(url, "POST", "/v1/hello", std::string(3 << 20, 'x')).status, 413);
}

TEST_F(ServePort, OverAWebSocketADemonstrationReachesItsGoalAndItsSessionEndsWithIt) {
  std::string session;
  {
    WebSocketClient client(url);
    std::string last;
    const auto calls = demonstrated_calls(data_set_in_all_modes(), "M3", 2);
    for (std::size_t i = 0; i < calls.size(); ++i) {
      last = client.say(request_line(static_cast<int>(i), calls[i]));
      expect_no_place(last);
      if (i == 0) session = Json::parse(last)["result"]["session"];
    }
    EXPECT_EQ(Json::parse(last)["result"]["reward"], 1.0);
    EXPECT_EQ(Json::parse(client.say(request_line(0, {"open"})))["error"]["code"], -32002);
    EXPECT_EQ(post({"observe", {{"session", session}}}).status, 200);
  }
  while (post({"observe", {{"session", session}}}).status == 200) std::this_thread::yield();
}

TEST_F(ServePort, APageOfSomeoneElseCanDoNothing) {
  EXPECT_EQ(ask(url, "POST", "/v1/open", "{}", {{"Origin", "http://evil.example"}}).status, 403);
  EXPECT_EQ(ask(url, "POST", "/v1/open", "{}", {{"Host", "evil.example"}}).status, 403);
  EXPECT_EQ(ask(url, "GET", "/", "", {{"Host", "evil.example"}}).status, 403);
  EXPECT_THROW(WebSocketClient(url, "/v1/ws", "http://evil.example"), std::runtime_error);
  const auto page = ask(url, "GET", "/");
  EXPECT_EQ(page.status, 200);
  EXPECT_EQ(page.headers.at("Content-Type"), "text/html; charset=utf-8");
  EXPECT_THAT(page.body, HasSubstr("Content-Security-Policy"));
  expect_no_place(page.body);
}

TEST_F(ServePort, ThePagesClientsWorkAsWritten) {
  const auto page = *read_file(fs::path(UNIETP_SOURCE_DIR) / "docs/protocol.md");
  const auto block = [&](const std::string& fence, const std::string& with) {
    for (auto start = page.find(fence); start != std::string::npos; start = page.find(fence, start + 1)) {
      const auto from = start + fence.size(), end = page.find("\n```\n", from);
      if (page.substr(from, end - from).find(with) != std::string::npos) return page.substr(from, end - from) + "\n";
    }
    return std::string("no such block");
  };
  const ScratchFolder scratch;
  ASSERT_TRUE(write_file(scratch.path() / "client.py", block("```python\n", "Popen")));
  fs::create_directory_symlink(data_set_in_all_modes(), scratch.path() / "set");
  for (const std::string mode : {"M1", "M3"}) {
    const auto played = run_script("python3 client.py set " + mode, scratch.path());
    EXPECT_EQ(played.code, 0) << played.err;
    std::string expected;
    for (const auto& task : json_lines(data_set_in_all_modes() / "tasks.jsonl"))
      expected += task["id"].get<std::string>() + " 1.0\n";
    EXPECT_EQ(played.out, expected);
  }
  const auto curl = run_script(replace_all(block("```sh\n", "curl"), "localhost:8080", url.substr(url.find("//") + 2)),
                               scratch.path());
  EXPECT_EQ(curl.code, 0) << curl.err;
  EXPECT_THAT(curl.out, HasSubstr("\"turn\":2"));
  EXPECT_THAT(curl.out, Not(HasSubstr("\"error\"")));
}

class ServeOne : public ServePort {
 protected:
  ServeOne() : ServePort("--sessions 1 --idle 5 --privileged") {}
};

TEST_F(ServeOne, SessionsAreBoundedAndIdleOnesEnd) {
  const std::string session = result({"open"})["session"];
  result({"reset", {{"session", session}, {"index", 0}}});
  EXPECT_TRUE(result({"state", {{"session", session}, {"scene", true}}}).contains("scene"));
  EXPECT_EQ(post({"open"}).status, 429);
  while (post({"open"}).status != 200) std::this_thread::yield();  // which does not use the first
  EXPECT_EQ(post({"observe", {{"session", session}}}).status, 404);
}

TEST(ServeCommand, RefusesWhatItCannotServe) {
  EXPECT_EQ(run_program({"serve"}).code, 2);
  EXPECT_EQ(run_program({"serve", "/nowhere"}).code, 2);
  EXPECT_EQ(run_program({"serve", UNIETP_SOURCE_DIR}).code, 2);
  EXPECT_EQ(run_program({"serve", data_set_in_all_modes().string(), "--port", "70000"}).code, 2);
  EXPECT_EQ(run_program({"serve", data_set_in_all_modes().string(), "--port", "0", "--host", "here"}).code, 2);
  EXPECT_EQ(run_program({"serve", data_set_in_all_modes().string(), "--host", "127.0.0.1"}).code, 2);
  EXPECT_EQ(run_program({"play", data_set_in_all_modes().string() + "/no-such-task", "--no-page"}).code, 2);
}

TEST(ServeProcedural, MakesANewTaskForEachSeed) {
  const auto answers = served_lines(
      data_set_in_all_modes(),
      request_lines(
          {{"open"}, {"reset", {{"procedural", 1}}}, {"reset", {{"procedural", 2}}}, {"reset", {{"procedural", 1}}}}),
      "--procedural --simulators behavior --splits atomic");
  const auto observation = [&](std::size_t i) { return Json::parse(answers.at(i))["result"]["observation"]; };
  EXPECT_TRUE(observation(1).is_object()) << answers[1];
  EXPECT_EQ(observation(1), observation(3));
  EXPECT_NE(observation(1), observation(2));
}

}  // namespace
}  // namespace unietp
