#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <variant>

#include "core/rng.h"
#include "llm/chat_reply.h"
#include "llm/chat_request.h"
#include "llm/exchange.h"

namespace unietp {

class Transport;

/// Until when a server wants to be left alone. Shared by all clients of a server, on several threads.
class ServerPause {
 public:
  using Clock = std::chrono::steady_clock;
  using Time = Clock::time_point;
  /// Sets that time unless a later one is set.
  void until(Time time);
  Time until() const;  // long ago when no server asked for it

 private:
  mutable std::mutex mutex_;
  Time time_{};
};

/// Limits and retries of a client.
struct ChatOptions {
  double attempt_s = 120;   // of one attempt, from the connection to the last byte
  int max_attempts = 8;     // >= 1, of one request
  double first_wait_s = 1;  // before the second attempt; doubles each time, plus a random part of the same size at most
  double longest_wait_s = 60;               // also an upper bound for Retry-After
  const std::atomic<bool>* stop = nullptr;  // when true, the request is abandoned within 0.1 s
};

/// Why there is no reply.
struct ChatFailure {
  enum class Kind { RateLimit, Server, Connection, Timeout, Rejected, Stopped };
  Kind kind = Kind::Server;
  long status = 0;      // 0: none
  std::string message;  // one line, without the key
};

/// A reply or why there is none, after so many attempts.
struct ChatAnswer {
  std::variant<ChatReply, ChatFailure> result;
  int attempts = 0;
};

/// Asks one chat after the other, each until there is a chat completion. Tried again: 408, 425, 429, 5xx, time-outs,
/// broken connections, and answers that are no chat completions or too long; after waits as Retry-After says or
/// doubling ones with jitter. A 429 or 503 with Retry-After holds back all clients with the same ServerPause. What a
/// completion says is the model's and never asked again. One client belongs to one thread.
class ChatClient {
 public:
  /// `server_pause` is never null. The endpoint's url is whole (chat_url).
  ChatClient(LlmEndpoint endpoint, const ChatOptions& options, std::shared_ptr<ServerPause> server_pause);
  ~ChatClient();

  /// `body`: of chat_body. `rng`: of the random part of the waits.
  ChatAnswer ask(const std::string& body, Rng rng);

 private:
  std::variant<ChatReply, ChatFailure> attempt(const std::string& body, double& asked_wait_s);
  bool stopped() const { return options_.stop != nullptr && *options_.stop; }

  LlmEndpoint endpoint_;
  ChatOptions options_;
  std::shared_ptr<ServerPause> server_pause_;
  std::unique_ptr<Transport> transport_;
};

}  // namespace unietp
