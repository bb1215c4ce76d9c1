#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <mutex>
#include <thread>

#include "bodies.h"
#include "fuzz_bodies.h"
#include "llm/ask.h"
#include "support.h"

namespace unietp::fuzz {
namespace {

/// Answers every connection to 127.0.0.1 with the same bytes and closes it.
class OneAnswer {
 public:
  OneAnswer() : listener_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    require(::bind(listener_, reinterpret_cast<sockaddr*>(&address), size) == 0 && ::listen(listener_, 64) == 0);
    ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
    url_ = "http://127.0.0.1:" + std::to_string(ntohs(address.sin_port)) + "/v1/chat/completions";
    thread_ = std::thread([this] { serve(); });
  }
  ~OneAnswer() {
    ::shutdown(listener_, SHUT_RDWR);
    thread_.join();
    ::close(listener_);
  }
  OneAnswer(const OneAnswer&) = delete;
  OneAnswer& operator=(const OneAnswer&) = delete;

  const std::string& url() const { return url_; }
  void set(std::string_view bytes) {
    const std::lock_guard lock(mutex_);
    bytes_ = bytes;
  }

 private:
  void serve() {
    for (int peer = accept(); peer >= 0; peer = accept()) {
      read_request(peer);
      std::string bytes;
      {
        const std::lock_guard lock(mutex_);
        bytes = bytes_;
      }
      for (std::size_t sent = 0; sent < bytes.size();) {
        const ssize_t now = ::send(peer, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
        if (now <= 0) break;
        sent += static_cast<std::size_t>(now);
      }
      ::close(peer);
    }
  }
  int accept() const { return ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC); }

  /// Until the body is whole, so that closing the connection does not reset it.
  static void read_request(int peer) {
    std::string bytes;
    char buffer[4096];
    for (;;) {
      const ssize_t got = ::recv(peer, buffer, sizeof buffer, 0);
      if (got <= 0) return;
      bytes.append(buffer, static_cast<std::size_t>(got));
      const auto end = bytes.find("\r\n\r\n"), length = bytes.find("Content-Length: ");
      if (end == std::string::npos || length == std::string::npos) continue;
      if (bytes.size() >= end + 4 + std::stoul(bytes.substr(length + 16))) return;
    }
  }

  int listener_;
  std::string url_, bytes_;
  std::mutex mutex_;  // of bytes_
  std::thread thread_;
};

}  // namespace

bool http_body(std::string_view text) {
  static OneAnswer server;
  server.set(text);
  constexpr std::string_view kKey = "sk-fuzz-0123";
  const LlmEndpoint endpoint{server.url(), "fuzz", std::string(kKey)};
  const std::vector<LlmRequest> requests{{"system", "user", "answer", "{\"type\":\"object\"}", {}, {}}};
  LlmOptions options;
  options.max_attempts = 1;
  options.attempt_s = options.total_s = 30;
  const auto answers = ask_all(endpoint, requests, options, nullptr);
  require(answers.size() == 1);
  const Result<LlmAnswer>& answer = answers.front();
  if (!answer) {
    check_error(answer.error());
    require(format(answer.error()).find(kKey) == std::string::npos);
    return false;
  }
  require(answer->text.starts_with('{') && answer->text.find(kKey) == std::string::npos);
  require(answer->prompt_tokens >= 0 && answer->completion_tokens >= 0 && answer->attempts == 1);
  return true;
}

}  // namespace unietp::fuzz
