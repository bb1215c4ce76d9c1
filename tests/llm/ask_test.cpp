#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <map>
#include <set>

#include <gmock/gmock.h>

#include "asking.h"

namespace unietp {
namespace {

using test::answer_to;
using test::ChatServer;
using test::completion;
using test::endpoint_of;
using test::http;
using test::question;
using test::questions;
using test::quick;
using test::Received;
using test::text_for;
using ::testing::HasSubstr;

TEST(AskAll, AnswersStandInTheOrderOfTheRequestsWhateverTheOrderOfArrival) {
  constexpr int kCount = 6;
  std::mutex mutex;
  std::condition_variable changed;
  std::set<std::string> answered;
  ChatServer server([&](const Received& received) {
    const int number = received.user.back() - '0';
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return number == kCount - 1 || answered.contains(question(number + 1).user); });
    return answer_to(received);
  });
  auto options = quick();
  options.at_once = kCount;
  std::vector<std::size_t> arrived;
  options.on_answer = [&](std::size_t request, const Result<LlmAnswer>&) {
    arrived.push_back(request);
    const std::lock_guard lock(mutex);
    answered.insert(question(static_cast<int>(request)).user);
    changed.notify_all();
  };
  const auto answers = ask_all(endpoint_of(server), questions(kCount), options, nullptr);
  EXPECT_THAT(arrived, ::testing::ElementsAre(5, 4, 3, 2, 1, 0));
  ASSERT_EQ(answers.size(), static_cast<std::size_t>(kCount));
  for (int i = 0; i < kCount; ++i) {
    const auto& answer = answers[static_cast<std::size_t>(i)];
    ASSERT_TRUE(answer) << format(answer.error());
    EXPECT_EQ(answer->text, text_for(i));
    EXPECT_EQ(answer->prompt_tokens, 11);
    EXPECT_EQ(answer->completion_tokens, 7);
    EXPECT_EQ(answer->attempts, 1);
  }
}

TEST(AskAll, KeepsNoMoreUnderWayThanTheLimit) {
  std::atomic<int> now = 0, most = 0;
  ChatServer server([&](const Received& received) {
    const int under_way = ++now;
    int before = most;
    while (before < under_way && !most.compare_exchange_weak(before, under_way)) {
    }
    auto answer = answer_to(received);
    --now;
    return answer;
  });
  auto options = quick();
  options.at_once = 3;
  const auto answers = ask_all(endpoint_of(server), questions(24), options, nullptr);
  EXPECT_EQ(totals_of(answers).asked, 24);
  EXPECT_LE(most, 3);
}

struct Trouble {
  const char* name;
  std::string answer;
};
void PrintTo(const Trouble& trouble, std::ostream* out) { *out << trouble.name; }

class PassingTrouble : public ::testing::TestWithParam<Trouble> {};

TEST_P(PassingTrouble, LosesNoAnswer) {
  std::mutex mutex;
  std::map<std::string, int> times;
  ChatServer server([&](const Received& received) {
    const std::lock_guard lock(mutex);
    return ++times[received.user] == 1 ? GetParam().answer : answer_to(received);
  });
  auto options = quick();
  if (GetParam().answer == ChatServer::kSilence) options.attempt_s = 0.05;
  options.max_attempts = 50;  // a busy machine may miss the short attempt more than once
  const auto answers = ask_all(endpoint_of(server), questions(5), options, nullptr);
  for (int i = 0; i < 5; ++i) {
    const auto& answer = answers[static_cast<std::size_t>(i)];
    ASSERT_TRUE(answer) << format(answer.error());
    EXPECT_EQ(answer->text, text_for(i));
    EXPECT_GE(answer->attempts, 2);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Troubles, PassingTrouble,
    ::testing::Values(
        Trouble{"TooManyRequests", http("429 Too Many Requests", "slow down", "Retry-After: 0\r\n")},
        Trouble{"TooManyRequestsForLong", http("429 Too Many Requests", "", "Retry-After: 86400\r\n")},
        Trouble{"TooManyRequestsUntilADate",
                http("429 Too Many Requests", "",
                     "Date: Wed, 21 Oct 2015 07:28:00 GMT\r\nRetry-After: Wed, 21 Oct 2015 07:27:00 GMT\r\n")},
        Trouble{"RetryAfterNonsense", http("429 Too Many Requests", "", "Retry-After: soon, -3 nan\r\n")},
        Trouble{"ServerError", http("500 Internal Server Error", "oh")},
        Trouble{"BadGateway", http("502 Bad Gateway", "<html><body>nginx</body></html>")},
        Trouble{"RequestTimeout", http("408 Request Timeout", "")}, Trouble{"Closed", ""},
        Trouble{"NoHttp", "SSH-2.0-server\r\n\r\n"}, Trouble{"CutHead", "HTTP/1.1 200 OK\r\nContent-Le"},
        Trouble{"CutBody", "HTTP/1.1 200 OK\r\nContent-Length: 500\r\n\r\n{\"choices\":[{\"mess"},
        Trouble{"CutChunk", "HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\nff\r\n{\"choices\""},
        Trouble{"Empty", http("200 OK", "")}, Trouble{"Html", http("200 OK", "<html>Log in</html>")},
        Trouble{"WrongJson", http("200 OK", R"({"choices":"none"})")},
        Trouble{"NullContent", http("200 OK", R"({"choices":[{"message":{"content":null}}]})")},
        Trouble{"Prose", completion("I would rather not.")}, Trouble{"CutObject", completion("{\"to\": \"ques")},
        Trouble{"List", completion("[1, 2]")}, Trouble{"Deep", http("200 OK", std::string(100000, '['))},
        Trouble{"DeepContent", completion(std::string(20000, '{'))},
        Trouble{"Huge", http("200 OK", std::string(std::size_t{5} << 20, 'x'))},
        Trouble{"Silence", ChatServer::kSilence}),
    [](const auto& trouble) { return std::string(trouble.param.name); });

TEST(AskAll, EndsARequestWithItsLastReasonAndTheOthersWell) {
  ChatServer server([](const Received& received) {
    return received.user == "question 1"
               ? http("503 Service Unavailable", R"({"error":{"message":"model is loading"}})")
               : answer_to(received);
  });
  const auto answers = ask_all(endpoint_of(server), questions(3), quick(), nullptr);
  ASSERT_TRUE(answers[0]);
  ASSERT_TRUE(answers[2]);
  ASSERT_FALSE(answers[1]);
  EXPECT_EQ(answers[1].error().kind, Error::Kind::Io);
  EXPECT_EQ(answers[1].error().message, "no answer: status 503, \"model is loading\" after 3 attempts");
}

TEST(AskAll, AsksNoSecondTimeWhatIsRefusedForGood) {
  for (const char* status : {"401 Unauthorized", "404 Not Found", "301 Moved Permanently"}) {
    ChatServer server([&](const Received&) { return http(status, "", "Location: http://example.com/\r\n"); });
    const auto answers = ask_all(endpoint_of(server), {question(0)}, quick(), nullptr);
    ASSERT_FALSE(answers[0]);
    EXPECT_THAT(answers[0].error().message, HasSubstr(std::string("status ") + std::string(status).substr(0, 3)));
    EXPECT_EQ(server.count(), 1);
  }
}

TEST(AskAll, EndsInItsTimeWhenNothingAnswers) {
  ChatServer server([](const Received&) { return ChatServer::kSilence; });
  auto options = quick();
  options.total_s = 0.05;
  const auto answers = ask_all(endpoint_of(server), questions(9), options, nullptr);
  for (const auto& answer : answers) {
    ASSERT_FALSE(answer);
    EXPECT_EQ(answer.error().kind, Error::Kind::Io);
  }
}

TEST(AskAll, AStopKeepsWhatCameAndGivesUpTheRest) {
  std::atomic<bool> stop = false;
  ChatServer server([](const Received& received) {
    return received.user == "question 0" ? answer_to(received) : ChatServer::kSilence;
  });
  auto options = quick();
  options.stop = &stop;
  options.on_answer = [&](std::size_t, const Result<LlmAnswer>&) { stop = true; };
  const auto answers = ask_all(endpoint_of(server), questions(3), options, nullptr);
  EXPECT_TRUE(answers[0]);
  ASSERT_FALSE(answers[1]);
  EXPECT_THAT(answers[1].error().message, HasSubstr("stopped"));
}

TEST(AskAll, AServerWithoutResponseFormatIsAskedInWords) {
  ChatServer server([](const Received& received) {
    if (received.structured) return http("400 Bad Request", R"({"error":{"message":"unknown field response_format"}})");
    return completion("<think>{\"to\": \"nobody\"}</think>Here you are:\n```json\n{\"to\": \"" + received.user +
                      "\"}\n```\nAnything else?");
  });
  auto options = quick();
  options.at_once = 1;
  const auto answers = ask_all(endpoint_of(server), questions(4), options, nullptr);
  for (int i = 0; i < 4; ++i) {
    const auto& answer = answers[static_cast<std::size_t>(i)];
    ASSERT_TRUE(answer) << format(answer.error());
    EXPECT_EQ(answer->text, text_for(i));
    EXPECT_EQ(answer->attempts, 1);
  }
  EXPECT_EQ(server.count(), 5);  // it is refused once, and not tried again
  EXPECT_THAT(server.received()[1].body, HasSubstr(R"({\"type\":\"object\"})"));  // the schema, in the prompt
}

TEST(AskAll, A400ForAnotherReasonIsTold) {
  ChatServer server([](const Received&) { return http("400 Bad Request", R"({"message":"prompt is too long"})"); });
  const auto answers = ask_all(endpoint_of(server), {question(0)}, quick(), nullptr);
  ASSERT_FALSE(answers[0]);
  EXPECT_EQ(answers[0].error().message, "no answer: status 400, \"prompt is too long\" after 1 attempt");
  EXPECT_EQ(server.count(), 2);
}

TEST(AskAll, EqualRequestsAreAskedOnceAndCostOnce) {
  ChatServer server(answer_to);
  const auto answers =
      ask_all(endpoint_of(server), {question(1), question(2), question(1), question(1)}, quick(), nullptr);
  EXPECT_EQ(server.count(), 2);
  EXPECT_EQ(answers[3]->text, text_for(1));
  const auto totals = totals_of(answers);
  EXPECT_EQ(totals.asked, 2);
  EXPECT_EQ(totals.cached, 2);
  EXPECT_EQ(totals.prompt_tokens, 22);
  EXPECT_EQ(totals.completion_tokens, 14);
  EXPECT_DOUBLE_EQ(cost_of(totals, {1e6, 2e6}), 22 + 28);
}

TEST(AskAll, CountsTheTokensOfAnswersThatCouldNotBeUsed) {
  ChatServer server(
      [](const Received& received) { return received.number == 0 ? completion("no") : answer_to(received); });
  const auto answers = ask_all(endpoint_of(server), {question(0)}, quick(), nullptr);
  ASSERT_TRUE(answers[0]);
  EXPECT_EQ(answers[0]->prompt_tokens, 22);
  EXPECT_EQ(answers[0]->attempts, 2);
}

TEST(AskAll, SendsParametersOnlyWhenTheyAreSet) {
  ChatServer server(answer_to);
  auto request = question(0);
  ASSERT_TRUE(ask_all(endpoint_of(server), {request}, quick(), nullptr)[0]);
  request.temperature = 0.5;
  request.max_tokens = 77;
  ASSERT_TRUE(ask_all(endpoint_of(server), {request}, quick(), nullptr)[0]);
  const auto received = server.received();
  EXPECT_EQ(received[0].body.find("temperature"), std::string::npos);
  EXPECT_EQ(received[0].body.find("max_tokens"), std::string::npos);
  EXPECT_THAT(received[1].body, HasSubstr("\"temperature\":0.5"));
  EXPECT_THAT(received[1].body, HasSubstr("\"max_tokens\":77"));
}

TEST(AskAll, RefusesAnEndpointThatNoAttemptCouldReach) {
  for (const char* url : {"", "file:///etc/passwd", "example.com/v1", "http://"}) {
    const auto answers = ask_all({url, "tiny", ""}, questions(2), quick(), nullptr);
    ASSERT_EQ(answers.size(), 2U);
    ASSERT_FALSE(answers[1]) << url;
    EXPECT_EQ(answers[1].error().kind, Error::Kind::Usage);
  }
}

TEST(ChatUrl, IsMadeWhole) {
  EXPECT_EQ(*chat_url("http://localhost:8080/v1"), "http://localhost:8080/v1/chat/completions");
  EXPECT_EQ(*chat_url("http://localhost:8080/v1/"), "http://localhost:8080/v1/chat/completions");
  EXPECT_EQ(*chat_url("https://a.example/v1/chat/completions"), "https://a.example/v1/chat/completions");
  EXPECT_EQ(*chat_url("https://a.example/x?api-version=3"), "https://a.example/x/chat/completions?api-version=3");
}

}  // namespace
}  // namespace unietp
