#include "llm/chat_client.h"

#include <algorithm>
#include <utility>

#include "core/pause.h"
#include "llm/chat.h"
#include "llm/retry_after.h"
#include "llm/transport.h"
#include "llm/waiting.h"

namespace unietp {
namespace {

using Kind = ChatFailure::Kind;
constexpr double kPoll_s = 0.05;  // longest delay until a stop is noticed

bool passes(const ChatFailure& failure) { return failure.kind != Kind::Rejected && failure.kind != Kind::Stopped; }

ChatFailure stopped_failure() { return {Kind::Stopped, 0, "stopped before an answer arrived"}; }

ChatFailure failure_of(const HttpAnswer& ended, const std::string& key) {
  if (!ended.failure.empty()) {
    const Kind kind = ended.timed_out ? Kind::Timeout : ended.too_large ? Kind::Server : Kind::Connection;
    return {kind, 0, "no answer: " + ended.failure};
  }
  ChatFailure failure{Kind::Rejected, ended.status, "status " + std::to_string(ended.status)};
  const auto said = error_message_in(ended.body, key);
  if (!said.empty()) failure.message += ", \"" + said + "\"";
  if (ended.status == 429) failure.kind = Kind::RateLimit;
  if (ended.status == 408 || ended.status == 425) failure.kind = Kind::Timeout;
  if (ended.status >= 500) failure.kind = Kind::Server;
  return failure;
}

}  // namespace

void ServerPause::until(Time time) {
  const std::scoped_lock lock(mutex_);
  time_ = std::max(time_, time);
}

ServerPause::Time ServerPause::until() const {
  const std::scoped_lock lock(mutex_);
  return time_;
}

ChatClient::ChatClient(LlmEndpoint endpoint, const ChatOptions& options, std::shared_ptr<ServerPause> server_pause)
    : endpoint_(std::move(endpoint)),
      options_(options),
      server_pause_(std::move(server_pause)),
      transport_(std::make_unique<Transport>(endpoint_, options.attempt_s)) {}
ChatClient::~ChatClient() = default;

std::variant<ChatReply, ChatFailure> ChatClient::attempt(const std::string& body, double& asked_wait_s) {
  transport_->start(0, body);
  std::vector<HttpAnswer> ended;
  while (ended.empty()) {
    if (stopped()) {
      transport_ = std::make_unique<Transport>(endpoint_, options_.attempt_s);  // abandons the request
      return stopped_failure();
    }
    ended = transport_->wait(kPoll_s);
  }
  const HttpAnswer& answer = ended.front();
  if (answer.failure.empty() && answer.status >= 200 && answer.status < 300) {
    auto reply = read_chat_reply(answer.body, endpoint_.key);
    if (reply) return std::move(*reply);
    return ChatFailure{Kind::Server, answer.status, format(reply.error())};
  }
  auto failure = failure_of(answer, endpoint_.key);
  if (const auto asked = retry_after_s(answer.retry_after, answer.date); asked && passes(failure)) {
    asked_wait_s = std::min(*asked, options_.longest_wait_s);
    if (answer.status == 429 || answer.status == 503)
      server_pause_->until(ServerPause::Clock::now() + seconds_long(asked_wait_s));
  }
  return failure;
}

ChatAnswer ChatClient::ask(const std::string& body, Rng rng) {
  double wait_s = options_.first_wait_s;
  for (int attempts = 1;; ++attempts) {
    if (!pause_until(server_pause_->until(), options_.stop)) return {stopped_failure(), attempts - 1};
    double asked_wait_s = -1;
    auto result = attempt(body, asked_wait_s);
    const auto* failure = std::get_if<ChatFailure>(&result);
    if (failure == nullptr || !passes(*failure) || attempts >= options_.max_attempts)
      return {std::move(result), attempts};
    const double pause =
        asked_wait_s >= 0 ? asked_wait_s : std::min(wait_s * (1 + rng.unit()), options_.longest_wait_s);
    wait_s *= 2;
    if (!pause_until(ServerPause::Clock::now() + seconds_long(pause), options_.stop))
      return {stopped_failure(), attempts};
  }
}

}  // namespace unietp
