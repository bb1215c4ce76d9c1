#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <string>
#include <thread>
#include <vector>

#include "annotator/llm_writer.h"
#include "small_knowledge.h"

namespace unietp {
namespace {

using testing_support::asking;
using testing_support::small_knowledge;

constexpr const char* kGoal = "(exists (?a - Mug) (exists (?b - Table) (at-end (on ?a ?b))))";
constexpr const char* kKey = "sk-very-secret-1234";

/// A server on 127.0.0.1 that gives each connection the next answer: the whole HTTP text, or "" to keep silent.
class Server {
 public:
  explicit Server(std::vector<std::string> answers) : answers_(std::move(answers)) {
    listener_ = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    ::bind(listener_, reinterpret_cast<sockaddr*>(&address), sizeof address);
    ::listen(listener_, 8);
    socklen_t size = sizeof address;
    ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
    url = "http://127.0.0.1:" + std::to_string(ntohs(address.sin_port)) + "/v1/chat/completions";
    thread_ = std::thread([this] { serve(); });
  }
  ~Server() {
    ::shutdown(listener_, SHUT_RDWR);
    thread_.join();
    for (const int silent : silent_) ::close(silent);
    ::close(listener_);
  }
  std::string url;
  std::vector<std::string> requests;  // read after the last answer

 private:
  void serve() {
    for (const std::string& answer : answers_) {
      const int peer = ::accept(listener_, nullptr, nullptr);
      if (peer < 0) return;
      timeval patience{2, 0};
      ::setsockopt(peer, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
      std::string request;
      char buffer[4096];
      for (std::size_t wanted = std::string::npos; request.size() < wanted;) {
        const ssize_t got = ::recv(peer, buffer, sizeof buffer, 0);
        if (got <= 0) break;
        request.append(buffer, static_cast<std::size_t>(got));
        const std::size_t end = request.find("\r\n\r\n"), length = request.find("Content-Length: ");
        if (end != std::string::npos && length != std::string::npos)
          wanted = end + 4 + static_cast<std::size_t>(std::stoul(request.substr(length + 16)));
        if (request.find("Expect: 100-continue") != std::string::npos && request.size() == end + 4)
          ::send(peer, "HTTP/1.1 100 Continue\r\n\r\n", 25, MSG_NOSIGNAL);
      }
      requests.push_back(request);
      if (answer.empty()) {
        silent_.push_back(peer);
        continue;
      }
      ::send(peer, answer.data(), answer.size(), MSG_NOSIGNAL);
      ::close(peer);
    }
  }
  std::vector<std::string> answers_;
  std::vector<int> silent_;
  int listener_ = -1;
  std::thread thread_;
};

std::string http(const std::string& status, const std::string& body, const std::string& header = "") {
  return "HTTP/1.1 " + status + "\r\n" + header + "Content-Length: " + std::to_string(body.size()) +
         "\r\nConnection: close\r\n\r\n" + body;
}

std::string saying(const std::string& text) {
  return http("200 OK", R"({"choices":[{"message":{"content":"{\"instruction\": \")" + text +
                            R"(\"}"}}],"usage":{"prompt_tokens":11,"completion_tokens":7}})");
}

LlmWriterOptions options_for(const Server& server) {
  LlmWriterOptions options;
  options.endpoint = {server.url, "tiny", kKey, 0.5, 3, 0.01, 0.05};
  return options;
}

Result<Instruction> written_by(Server& server) {
  return write_instruction_with_llm(asking(kGoal), small_knowledge(), options_for(server), Rng(1));
}

TEST(LlmWriter, TakesAnAnswerThatSaysTheGoal) {
  Server server({saying("Place one mug on the table.")});
  const auto written = written_by(server);
  ASSERT_TRUE(written);
  EXPECT_EQ(written->text, "Place one mug on the table.");
  EXPECT_EQ(written->writer, "llm:tiny");
  ASSERT_EQ(server.requests.size(), 1u);
  EXPECT_NE(server.requests[0].find("json_schema"), std::string::npos);
  EXPECT_NE(server.requests[0].find(std::string("Bearer ") + kKey), std::string::npos);
}

TEST(LlmWriter, SendsBackWhatWasWrongAndTakesTheNext) {
  Server server({saying("Put a mug in the fridge."), saying("Put a mug on the table.")});
  const auto written = written_by(server);
  ASSERT_TRUE(written);
  EXPECT_EQ(written->writer, "llm:tiny");
  ASSERT_EQ(server.requests.size(), 2u);
  EXPECT_NE(server.requests[1].find("refused"), std::string::npos);
}

TEST(LlmWriter, WaitsAsAskedAndTriesAgain) {
  Server server({http("429 Too Many Requests", "slow down", "Retry-After: 0\r\n"), http("503 Busy", ""),
                 saying("Put a mug on the table.")});
  const auto written = written_by(server);
  ASSERT_TRUE(written);
  EXPECT_EQ(written->writer, "llm:tiny");
}

TEST(LlmWriter, FallsBackToTheGrammarAfterGarbage) {
  Server server(
      {http("200 OK", "<html>"), http("200 OK", "{}"), saying("Fly to the moon."), saying("Put mug_3 away.")});
  const auto written = written_by(server);
  ASSERT_TRUE(written);
  EXPECT_EQ(written->writer, "grammar");
  EXPECT_TRUE(check_instruction(written->text, asking(kGoal), small_knowledge()).empty());
}

TEST(LlmWriter, FallsBackToTheGrammarWhenNothingComes) {
  Server server({"", "", ""});
  const auto written = written_by(server);
  ASSERT_TRUE(written);
  EXPECT_EQ(written->writer, "grammar");
}

TEST(LlmClient, NeverShowsTheKeyInAnError) {
  const std::string leak = std::string("your key ") + kKey + " is bad";
  for (const std::string& answer : {http("401 Unauthorized", leak), http("200 OK", leak), std::string()}) {
    Server server({answer, answer, answer});
    const auto got = ask_llm(options_for(server).endpoint, {"s", "u", "instruction"}, Rng(1));
    ASSERT_FALSE(got);
    EXPECT_EQ(format(got.error()).find(kKey), std::string::npos) << format(got.error());
  }
}

}  // namespace
}  // namespace unietp
