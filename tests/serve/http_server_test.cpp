#include "serve/http_server.h"

#include <atomic>
#include <optional>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client.h"

namespace unietp {
namespace {

using test::ask;
using test::ask_raw;
using test::WebSocketClient;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::size_t kMessageBytes = 1000;

/// Answers with what it was asked, in a thread of its own until it goes.
class EchoServer {
 public:
  explicit EchoServer(std::size_t connections = 8) {
    HttpService service;
    service.request = [this](const HttpRequest& request) {
      ++requests;
      return HttpResponse{200, "text/plain", request.method + " " + request.target + " " + request.body};
    };
    service.message = [](ConnectionId, std::string_view text) { return "you said " + std::string(text); };
    service.closed = [this](ConnectionId) { ++closed; };
    auto made = HttpServer::listen({.socket = "/v1/ws", .message_bytes = kMessageBytes, .connections = connections},
                                   std::move(service));
    EXPECT_TRUE(made);
    server_.emplace(std::move(*made));
    url = server_->url();
    thread_ = std::thread([this] {
      while (!stop_) server_->serve(std::chrono::milliseconds(5));
    });
  }
  ~EchoServer() {
    stop_ = true;
    thread_.join();
  }
  EchoServer(const EchoServer&) = delete;
  EchoServer& operator=(const EchoServer&) = delete;

  std::string url;
  std::atomic<int> requests = 0, closed = 0;

 private:
  std::optional<HttpServer> server_;
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

TEST(HttpServer, AnswersRequestsWithHeadersThatKeepAnswersToThePage) {
  EchoServer server;
  const auto reply = ask(server.url, "POST", "/v1/step?x", "body");
  EXPECT_EQ(reply.status, 200);
  EXPECT_EQ(reply.body, "POST /v1/step?x body");
  EXPECT_EQ(reply.headers.at("X-Content-Type-Options"), "nosniff");
  EXPECT_EQ(reply.headers.at("Cache-Control"), "no-store");
  EXPECT_EQ(reply.headers.at("X-Frame-Options"), "DENY");
  EXPECT_EQ(reply.headers.count("Access-Control-Allow-Origin"), 0U);
}

TEST(HttpServer, RefusesWhatAPageOfSomeoneElseCouldSendAndDoesNotAskTheService) {
  EchoServer server;
  EXPECT_EQ(ask(server.url, "POST", "/v1/open", "{}", {{"Origin", "http://evil.example"}}).status, 403);
  EXPECT_EQ(ask(server.url, "POST", "/v1/open", "{}", {{"Origin", "null"}}).status, 403);
  EXPECT_EQ(ask(server.url, "POST", "/v1/open", "{}", {{"Host", "evil.example"}}).status, 403);
  EXPECT_EQ(ask(server.url, "GET", "/", "", {{"Host", "evil.example:80"}}).status, 403);
  EXPECT_THROW(WebSocketClient(server.url, "/v1/ws", "http://evil.example"), std::runtime_error);
  EXPECT_EQ(server.requests, 0);
  EXPECT_EQ(server.closed, 0);
  EXPECT_EQ(ask(server.url, "POST", "/v1/open", "{}", {{"Origin", server.url}}).status, 200);
}

TEST(HttpServer, BoundsHeadersBodiesAndMessages) {
  EchoServer server;
  EXPECT_EQ(ask(server.url, "POST", "/", std::string(kMessageBytes, 'x')).status, 200);
  EXPECT_EQ(ask(server.url, "POST", "/", std::string(kMessageBytes + 1, 'x')).status, 413);
  EXPECT_EQ(ask(server.url, "GET", "/", "", {{"X-Long", std::string(20'000, 'x')}}).status, 431);
  EXPECT_THAT(ask_raw(server.url, "no HTTP at all\r\n\r\n"), HasSubstr("400 Bad Request"));
  EXPECT_THAT(ask_raw(server.url, "POST / HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: -1\r\n\r\n"),
              HasSubstr("400 Bad Request"));
  WebSocketClient client(server.url);
  EXPECT_EQ(client.say("hello"), "you said hello");
  EXPECT_THROW(client.say(std::string(kMessageBytes + 1, 'x')), std::runtime_error);
}

TEST(HttpServer, TellsOfEachWebSocketThatClosesOnce) {
  EchoServer server;
  {
    WebSocketClient one(server.url), two(server.url);
    EXPECT_EQ(one.say("1"), "you said 1");
    EXPECT_EQ(two.say("2"), "you said 2");
    EXPECT_EQ(one.say("3"), "you said 3");
    EXPECT_EQ(server.closed, 0);
  }
  while (server.closed < 2) std::this_thread::yield();
  EXPECT_EQ(ask(server.url, "GET", "/v1/ws").status, 426);
  EXPECT_EQ(server.closed, 2);
}

TEST(HttpServer, ClosesConnectionsBeyondTheirNumberAndTakesOthersWhenThoseEnd) {
  EchoServer server(2);
  {
    WebSocketClient one(server.url), two(server.url);
    EXPECT_EQ(one.say("1"), "you said 1");
    EXPECT_EQ(two.say("2"), "you said 2");
    EXPECT_EQ(ask(server.url, "GET", "/").status, 0);
  }
  while (server.closed < 2) std::this_thread::yield();
  while (ask(server.url, "GET", "/").status != 200) std::this_thread::yield();
}

TEST(HttpServer, RefusesAHostThatIsNoAddressAndAPortThatIsTaken) {
  const auto named = HttpServer::listen({.host = "localhost"}, {});
  ASSERT_FALSE(named);
  EXPECT_EQ(named.error().kind, Error::Kind::Usage);
  EchoServer server;
  const int port = std::stoi(server.url.substr(server.url.rfind(':') + 1));
  const auto taken = HttpServer::listen({.port = port}, {});
  ASSERT_FALSE(taken);
  EXPECT_EQ(taken.error().kind, Error::Kind::Io);
  EXPECT_THAT(taken.error().message, HasSubstr("cannot listen"));
}

}  // namespace
}  // namespace unietp
