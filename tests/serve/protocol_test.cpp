#include "serve/protocol.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/limits.h"
#include "kitchen_tasks.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;
using std::chrono::seconds;
using ::testing::HasSubstr;
using testing::kitchen_plan;
using testing::kitchen_tasks;
using ::testing::Not;
using ::testing::StartsWith;

/// A client of a server with the kitchen, and the clock of both.
class ProtocolClient : public ::testing::Test {
 protected:
  ProtocolClient() : ProtocolClient(ProtocolOptions()) {}
  explicit ProtocolClient(ProtocolOptions options)
      : protocol((
            options.log = [this](const Error& error) { logged.push_back(error); },
            Protocol(kitchen_tasks(), std::move(options)))) {}

  /// The whole response.
  Json said(const std::string& text) { return Json::parse(protocol.message(text, caller, now)); }
  Json call(const std::string& method, const Json& parameters = Json::object()) {
    const auto response = said(Json{{"jsonrpc", "2.0"}, {"id", 1}, {"method", method}, {"params", parameters}}.dump());
    EXPECT_EQ(response["jsonrpc"], "2.0");
    EXPECT_EQ(response["id"], 1);
    return response;
  }
  Json result(const std::string& method, const Json& parameters = Json::object()) {
    const auto response = call(method, parameters);
    EXPECT_TRUE(response.contains("result")) << response;
    return response.value("result", Json());
  }
  int code(const std::string& method, const Json& parameters = Json::object()) {
    const auto response = call(method, parameters);
    EXPECT_TRUE(response.contains("error")) << response;
    EXPECT_NE(response["error"].value("message", ""), "");
    return response["error"].value("code", 0);
  }
  std::string opened(const Json& settings = Json::object()) { return result("open", settings)["session"]; }

  std::vector<Error> logged;
  ServerTime now{};
  Caller caller{100};
  Protocol protocol;
};

int number(CallFailure failure) { return static_cast<int>(failure); }

TEST_F(ProtocolClient, SaysWhoItIsAndWhatItCanDo) {
  const auto hello = result("hello");
  EXPECT_EQ(hello["name"], "unietp");
  EXPECT_EQ(hello["protocol"], 1);
  EXPECT_EQ(hello["methods"], Json({"hello", "tasks", "open", "reset", "step", "observe", "text", "actions", "render",
                                    "state", "close"}));
  EXPECT_EQ(hello["tasks"], 0);
  EXPECT_EQ(hello["procedural"], true);
  EXPECT_EQ(hello["privileged"], false);
  EXPECT_EQ(result("tasks"), Json({{"total", 0}, {"tasks", Json::array()}}));
}

TEST_F(ProtocolClient, APlanReachesItsGoalAndTheRewardComesAtTheEnd) {
  const auto session = opened({{"mode", "M1"}});
  const auto first = result("reset", {{"session", session}, {"procedural", 1}});
  EXPECT_EQ(first["task"], "kitchen-1");
  EXPECT_EQ(first["turn"], 1);
  EXPECT_EQ(first["observation"]["instruction"], "Put the mug on the counter.");
  EXPECT_EQ(first["observation"]["step"], 0);
  for (const auto& action : kitchen_plan()) {
    const bool is_last = action == kitchen_plan().back();
    const auto step = result("step", {{"session", session}, {"action", Json::parse(action)}});
    EXPECT_EQ(step["observation"]["last"]["success"], true) << step;
    EXPECT_EQ(step["reward"], is_last ? 1.0 : 0.0);
    EXPECT_EQ(step["terminated"], is_last);
    EXPECT_EQ(step["truncated"], false);
    EXPECT_EQ(result("observe", {{"session", session}}), step);  // for whoever lost the answer
  }
  const auto after = result("step", {{"session", session}, {"action", "stop"}});
  EXPECT_EQ(after["reward"], 0.0);
  EXPECT_EQ(after["observation"]["over"], true);
}

TEST_F(ProtocolClient, ATextOfAnAgentIsAnActionAndWhatCannotBeReadIsAFailedStep) {
  const auto session = opened();
  result("reset", {{"session", session}, {"procedural", 1}});
  EXPECT_EQ(result("step", {{"session", session}, {"action", "go_to(mug_1)"}})["observation"]["last"]["success"], true);
  EXPECT_EQ(result("step", {{"session", session},
                            {"action", "```json\n" + kitchen_plan()[1] + "\n```"}})["observation"]["last"]["success"],
            true);
  for (const Json& nonsense : {Json("I think I should"), Json(7), Json(), Json::array(), Json({{"action", 3}})}) {
    const auto step = result("step", {{"session", session}, {"action", nonsense}});
    EXPECT_EQ(step["observation"]["last"]["success"], false) << nonsense;
    EXPECT_NE(step["observation"]["last"]["feedback"], "") << nonsense;
  }
}

TEST_F(ProtocolClient, SessionsThatTakeTurnsAnswerLikeSessionsAlone) {
  const auto play = [this](const std::string& session, const std::vector<std::string>& actions, std::size_t i) {
    const Json parameters = i == 0 ? Json{{"session", session}, {"procedural", 1}}
                                   : Json{{"session", session}, {"action", Json::parse(actions[i - 1])}};
    return protocol.call(i == 0 ? "reset" : "step", parameters.dump(), now).body;
  };
  auto other = kitchen_plan();
  other.front() = R"({"action": "go_to", "args": ["apple_1"]})";
  const auto alone = [&](const std::vector<std::string>& actions) {
    const auto session = opened({{"pictures", true}});
    std::string answers;
    for (std::size_t i = 0; i <= actions.size(); ++i) answers += play(session, actions, i) + "\n";
    return answers;
  };
  const auto one = alone(kitchen_plan()), two = alone(other);
  EXPECT_NE(one, two);
  const auto a = opened({{"pictures", true}}), b = opened({{"pictures", true}});
  std::string of_a, of_b;
  for (std::size_t i = 0; i <= kitchen_plan().size(); ++i) {
    of_a += play(a, kitchen_plan(), i) + "\n";
    of_b += play(b, other, i) + "\n";
  }
  EXPECT_EQ(of_a, one);
  EXPECT_EQ(of_b, two);
}

TEST_F(ProtocolClient, ACallNeedsNoSessionWhereThereIsOnlyOneAndRefusesUnknownOnes) {
  EXPECT_EQ(code("reset", {{"procedural", 1}}), number(CallFailure::WrongParameters));
  const auto session = opened();
  EXPECT_EQ(result("reset", {{"procedural", 1}})["turn"], 1);
  EXPECT_EQ(code("observe", {{"session", "2"}}), number(CallFailure::UnknownSession));
  opened();
  EXPECT_EQ(code("observe"), number(CallFailure::WrongParameters));
  EXPECT_EQ(result("observe", {{"session", session}})["turn"], 1);
  EXPECT_EQ(result("close", {{"session", session}}), Json::object());
  EXPECT_EQ(code("observe", {{"session", session}}), number(CallFailure::UnknownSession));
  EXPECT_EQ(code("close", {{"session", session}}), number(CallFailure::UnknownSession));
  EXPECT_EQ(code("observe"), number(CallFailure::NotReset));  // the other is the only one now
}

TEST_F(ProtocolClient, RendersDepthAndNormalsOfWhatTheAgentSees) {
  opened();
  result("reset", {{"procedural", 1}});
  const auto seen = [&](const char* channel) {
    return result("render", {{"channel", channel}, {"width", 48}, {"height", 32}});
  };
  const auto depth = seen("depth"), normals = seen("normals"), color = seen("color");
  EXPECT_EQ(depth["width"], 48);
  EXPECT_EQ(depth["height"], 32);
  EXPECT_FALSE(depth.contains("ids"));
  const std::set<std::string> files{depth["png"], normals["png"], color["png"]};
  EXPECT_EQ(files.size(), 3U);
  for (const std::string& file : files) EXPECT_THAT(file, StartsWith("iVBORw0KGgo"));  // PNG in base64
  EXPECT_EQ(seen("depth"), depth);
  result("step", {{"action", "turn_left"}});
  EXPECT_NE(seen("depth"), depth);
  EXPECT_EQ(code("render", {{"channel", "instances"}}), number(CallFailure::NotAllowed));
  EXPECT_EQ(code("render", {{"camera", "above"}}), number(CallFailure::NotAllowed));
}

TEST_F(ProtocolClient, AnObservationThatIsKnownAlreadyIsNotSentAgain) {
  opened();
  result("reset", {{"procedural", 1}});
  EXPECT_EQ(result("observe", {{"turn", 1}}), Json({{"turn", 1}}));
  EXPECT_TRUE(result("observe", {{"turn", 0}}).contains("observation"));
}

TEST_F(ProtocolClient, ParametersAreReadStrictly) {
  opened();
  const int wrong = number(CallFailure::WrongParameters);
  EXPECT_EQ(code("reset"), wrong);
  EXPECT_EQ(code("reset", {{"procedural", -1}}), wrong);
  EXPECT_EQ(code("reset", {{"procedural", "1"}}), wrong);
  EXPECT_EQ(code("reset", {{"procedural", 1}, {"seed", 1}}), wrong);
  EXPECT_EQ(code("reset", {{"procedural", 1}, {"episode", 1}}), wrong);
  EXPECT_EQ(code("reset", {{"procedural", 1}, {"colour", 1}}), wrong);
  result("reset", {{"procedural", 1}});
  EXPECT_EQ(code("step"), wrong);
  EXPECT_EQ(code("observe", {{"turn", 1.5}}), wrong);
  EXPECT_EQ(code("render", {{"boxes", "yes"}}), wrong);
  EXPECT_EQ(code("render", {{"boxes", true}, {"channel", "depth"}}), wrong);
  EXPECT_EQ(code("render", {{"channel", "heat"}}), wrong);
  EXPECT_EQ(code("render", {{"width", 8}}), wrong);
  EXPECT_EQ(code("open", {{"mode", "M4"}}), wrong);
  EXPECT_EQ(code("open", {{"pictures", 1}}), wrong);
  EXPECT_EQ(code("open", {{"picture", false}, {"pictures", true}}), wrong);
  EXPECT_EQ(code("open", {{"image_width", 1e9}}), wrong);
  EXPECT_THAT(call("open", {{"teleport", "moon"}})["error"]["message"].get<std::string>(), StartsWith("teleport: "));
  EXPECT_THAT(call("observe", {{"turn", "x"}})["error"]["message"].get<std::string>(), StartsWith("/turn: "));
  EXPECT_EQ(code("dance"), number(CallFailure::UnknownMethod));
  EXPECT_EQ(code("reset", {{"task", "kitchen-1"}}), number(CallFailure::NoTask));  // there is no data set
}

TEST_F(ProtocolClient, WhatIsNoRequestIsAnsweredWithAnErrorAndItsIdWhereThereIsOne) {
  const std::vector<std::pair<std::string, int>> bad{
      {"", -32700},
      {"{", -32700},
      {"\xff", -32700},
      {"[]", -32600},
      {"7", -32600},
      {"{}", -32600},
      {R"({"jsonrpc":"2.0","method":"hello"})", -32600},
      {R"({"jsonrpc":"2.0","id":null,"method":"hello"})", -32600},
      {R"({"jsonrpc":"2.0","id":[],"method":"hello"})", -32600},
      {R"({"id":7,"method":"hello"})", -32600},
      {R"({"jsonrpc":2,"id":7,"method":"hello"})", -32600},
      {R"({"jsonrpc":"2.0","id":7})", -32600},
      {R"({"jsonrpc":"2.0","id":7,"method":[]})", -32600},
      {R"({"jsonrpc":"2.0","id":7,"method":"hello","params":[]})", -32600},
      {R"({"jsonrpc":"2.0","id":7,"method":"hello","more":1})", -32600},
      {R"({"jsonrpc":"2.0","id":7,"id":8,"method":"hello"})", -32600},
      {R"([{"jsonrpc":"2.0","id":7,"method":"hello"}])", -32600},
      {std::string(100'000, '['), -32600},
      {R"({"jsonrpc":"2.0","id":7,"method":"open","params":)" + std::string(limits::kJsonDepth + 1, '[') +
           std::string(limits::kJsonDepth + 1, ']') + "}",
       -32600}};
  for (const auto& [text, expected] : bad) {
    const auto response = said(text);
    EXPECT_EQ(response["error"]["code"], expected) << text.substr(0, 80) << "\n" << response;
    const bool tells_id = text.find("\"id\":7") != std::string::npos && text.front() == '{' &&
                          text.find("[[") == std::string::npos && text.find("\"id\":8") == std::string::npos;
    EXPECT_EQ(response["id"], tells_id ? Json(7) : Json()) << text.substr(0, 80);
  }
  EXPECT_EQ(Json::parse(Protocol::too_long())["error"]["code"], -32600);
}

TEST_F(ProtocolClient, NothingOfAFileThatCannotBeReadIsInTheAnswer) {
  opened();
  const auto response = call("reset", {{"procedural", 99}});
  EXPECT_EQ(response["error"]["code"], number(CallFailure::NoTask));
  EXPECT_THAT(response.dump(), Not(HasSubstr("home")));
  ASSERT_EQ(logged.size(), 1U);
  EXPECT_THAT(logged.front().message, HasSubstr("secret"));
}

TEST_F(ProtocolClient, WhatAgentsMustNotKnowIsRefused) {
  opened();
  result("reset", {{"procedural", 1}});
  EXPECT_EQ(code("state"), number(CallFailure::NotAllowed));
}

class PrivilegedClient : public ProtocolClient {
 protected:
  PrivilegedClient() : ProtocolClient({.privileged = true}) {}
};

TEST_F(PrivilegedClient, AsksForGoalProgressAndScene) {
  opened();
  result("reset", {{"procedural", 1}});
  const auto state = result("state", {{"scene", true}, {"expert", true}});
  EXPECT_EQ(state["success"], false);
  EXPECT_THAT(state["goal"].get<std::string>(), HasSubstr("(on ?m ?c)"));
  EXPECT_TRUE(state["scene"].contains("nodes"));
  EXPECT_EQ(state["expert_steps_left"], 3);  // pick_up, place_on, stop: both are within reach
  EXPECT_FALSE(result("state").contains("scene"));
}

TEST_F(PrivilegedClient, RendersOtherCamerasAndTheObjectsOfPixels) {
  opened();
  result("reset", {{"procedural", 1}});
  const auto own = result("render", {{"channel", "instances"}});
  const auto above = result("render", {{"channel", "instances"}, {"camera", "above"}, {"width", 64}, {"height", 64}});
  EXPECT_EQ(own["ids"][0], "");
  EXPECT_THAT(own["ids"].get<std::vector<std::string>>(), ::testing::Contains("mug_1"));
  EXPECT_EQ(above["ids"].size(), own["ids"].size() + 1);
  EXPECT_EQ(above["ids"].back(), "agent");
  EXPECT_NE(above["png"], own["png"]);
  EXPECT_EQ(code("render", {{"camera", "below"}}), number(CallFailure::WrongParameters));
}

class FewSessions : public ProtocolClient {
 protected:
  FewSessions() : ProtocolClient({.sessions = 2, .idle = seconds(10)}) {}
};

TEST_F(FewSessions, AreBoundedAndThoseThatNobodyUsesAreClosed) {
  const auto first = opened(), second = opened();
  EXPECT_EQ(code("open"), number(CallFailure::TooManySessions));
  now += seconds(10);
  EXPECT_EQ(code("open"), number(CallFailure::TooManySessions));
  result("reset", {{"session", second}, {"procedural", 1}});  // which uses it
  now += seconds(1);
  EXPECT_EQ(code("reset", {{"session", first}, {"procedural", 1}}), number(CallFailure::UnknownSession));
  opened();
  EXPECT_TRUE(result("observe", {{"session", second}}).contains("observation"));
}

TEST_F(FewSessions, EndWithTheirCallerWhoMayHaveFewerOfHisOwn) {
  caller.most_sessions = 1;
  opened();
  EXPECT_EQ(code("open"), number(CallFailure::TooManySessions));
  protocol.leave(caller);
  EXPECT_TRUE(caller.sessions.empty());
  opened();
  caller = Caller{1};
  opened();
  protocol.leave(caller);
  opened();
}

TEST_F(ProtocolClient, TheFormOfHttpHasTheSameResultsAndNeedsATokenEachTime) {
  const auto opened = protocol.call("open", R"({"mode": "M3"})", now);
  ASSERT_FALSE(opened.failure);
  const std::string session = Json::parse(opened.body)["session"];
  const auto first = protocol.call("reset", Json{{"session", session}, {"procedural", 1}}.dump(), now);
  ASSERT_FALSE(first.failure);
  EXPECT_FALSE(Json::parse(first.body)["observation"].contains("boxes"));
  EXPECT_EQ(protocol.call("observe", "", now).failure, CallFailure::WrongParameters);
  EXPECT_EQ(protocol.call("observe", "[]", now).failure, CallFailure::NotARequest);
  EXPECT_EQ(protocol.call("observe", "{", now).failure, CallFailure::NotJson);
  const auto lost = protocol.call("observe", R"({"session": "no"})", now);
  EXPECT_EQ(lost.failure, CallFailure::UnknownSession);
  EXPECT_EQ(Json::parse(lost.body)["error"]["code"], number(CallFailure::UnknownSession));
}

TEST(Tokens, OfAPortCannotBeGuessed) {
  const auto token = secret_tokens();
  const auto one = token(), two = token();
  EXPECT_EQ(one.size(), 32U);
  EXPECT_NE(one, two);
  EXPECT_EQ(one.find_first_not_of("0123456789abcdef"), std::string::npos);
}

}  // namespace
}  // namespace unietp
