#include "llm/ask.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <nlohmann/json.hpp>

#include "core/digest.h"
#include "core/rng.h"
#include "core/text.h"
#include "llm/cache.h"
#include "llm/chat.h"
#include "llm/json_object.h"
#include "llm/redact.h"
#include "llm/retry_after.h"
#include "llm/transport.h"
#include "llm/waiting.h"

namespace unietp {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double kLongestPoll_s = 0.1;  // longest delay until a stop is noticed

Error io_error(const std::string& message) { return {Error::Kind::Io, "language model", {}, message}; }

/// A request that is not answered yet.
struct PendingRequest {
  std::size_t request = 0;  // the first of several equal ones
  std::string digest;
  int attempts = 0;
  bool in_words = false;      // sent without response_format
  bool refused_form = false;  // the server answered 400 or 422 to response_format
  double wait_s = 0;
  Rng rng{0};
  LlmAnswer spent;  // tokens of attempts whose answers could not be used
  Clock::time_point not_before{};
  bool in_progress = false;
};

/// Sends the requests of one call, with retries, and collects their answers.
class RequestLoop {
 public:
  RequestLoop(const LlmEndpoint& endpoint, const std::vector<LlmRequest>& requests, const LlmOptions& options,
              LlmCache* cache)
      : endpoint_(endpoint),
        requests_(requests),
        options_(options),
        cache_(cache),
        answers_(requests.size()),
        transport_(endpoint, std::min(options.attempt_s, options.total_s)) {}

  std::vector<Result<LlmAnswer>> run() {
    const auto end = Clock::now() + seconds_long(options_.total_s);
    queue_uncached();
    while (!pending_.empty()) {
      if (options_.stop != nullptr && *options_.stop) {
        fail_pending("stopped before an answer arrived");
        break;
      }
      const auto now = Clock::now();
      if (now >= end) {
        fail_pending("no answer within " + number_text(options_.total_s) + " s for all requests");
        break;
      }
      start_ready(now);
      const double pause =
          std::min(kLongestPoll_s, std::chrono::duration<double>(std::min(next_event(), end) - now).count());
      for (auto& ended : transport_.wait(std::max(pause, 0.001))) handle_answer(std::move(ended));
    }
    std::vector<Result<LlmAnswer>> all;
    all.reserve(answers_.size());
    for (auto& answer : answers_) all.push_back(std::move(*answer));
    return all;
  }

 private:
  void queue_uncached() {
    std::map<std::string, std::size_t> first;
    for (std::size_t i = 0; i < requests_.size(); ++i) {
      const auto digest = digest_of(endpoint_, requests_[i]);
      const auto [at, is_new] = first.emplace(digest, i);
      duplicates_[at->second].push_back(i);
      if (!is_new) continue;
      PendingRequest request;
      request.request = i;
      request.digest = digest;
      request.wait_s = options_.first_wait_s;
      request.rng = Rng(options_.seed).fork("llm wait", i);
      pending_.push_back(std::move(request));
    }
    if (cache_ == nullptr) return;
    for (const auto& request : std::vector<PendingRequest>(pending_)) {
      auto kept = cache_->find(request.digest);
      if (kept && json_object_in(kept->text)) finish(request.request, std::move(*kept));
    }
  }

  void start_ready(Clock::time_point now) {
    if (now < all_not_before_) return;
    for (auto& request : pending_) {
      if (transport_.in_progress() >= std::max(1, options_.at_once)) return;
      if (request.in_progress || now < request.not_before) continue;
      request.in_progress = true;
      ++request.attempts;
      const bool in_words = request.in_words || server_wants_words_;
      request.in_words = in_words;
      transport_.start(request.request, chat_body(endpoint_, requests_[request.request],
                                                  in_words ? LlmForm::Words : LlmForm::ResponseFormat));
    }
  }

  Clock::time_point next_event() const {
    auto next = Clock::time_point::max();
    for (const auto& request : pending_) {
      if (!request.in_progress) next = std::min(next, std::max(request.not_before, all_not_before_));
    }
    return next;
  }

  void handle_answer(HttpAnswer ended) {
    const auto at =
        std::find_if(pending_.begin(), pending_.end(), [&](const PendingRequest& o) { return o.request == ended.id; });
    PendingRequest& request = *at;
    request.in_progress = false;
    if (!ended.failure.empty()) return retry(request, ended, io_error("no answer: " + ended.failure));
    if (ended.status >= 200 && ended.status < 300) return handle_completion(request, ended);
    const bool refuses_form = (ended.status == 400 || ended.status == 422) && !request.in_words;
    if (refuses_form) {
      request.in_words = true;
      request.refused_form = true;
      --request.attempts;
      return;
    }
    auto message = "no answer: status " + std::to_string(ended.status);
    const auto message_of_server = error_message_in(ended.body, endpoint_.key);
    if (!message_of_server.empty()) message += ", \"" + message_of_server + "\"";
    const bool passes = ended.status == 408 || ended.status == 425 || ended.status == 429 || ended.status >= 500;
    if (passes) return retry(request, ended, io_error(message));
    finish(request.request, after(request, io_error(message)));
  }

  void handle_completion(PendingRequest& request, const HttpAnswer& ended) {
    auto read = read_completion(ended.body, endpoint_.key);
    if (!read) {
      const LlmAnswer usage = usage_in(ended.body);
      request.spent.prompt_tokens += usage.prompt_tokens;
      request.spent.completion_tokens += usage.completion_tokens;
      request.in_words = true;  // a server may ignore response_format
      return retry(request, ended, read.error());
    }
    if (request.refused_form) server_wants_words_ = true;  // the server rejected response_format, not the request
    read->prompt_tokens += request.spent.prompt_tokens;
    read->completion_tokens += request.spent.completion_tokens;
    read->attempts = request.attempts;
    if (cache_ != nullptr) cache_->store(request.digest, endpoint_.model, *read);
    finish(request.request, std::move(*read));
  }

  static Error after(const PendingRequest& request, Error reason) {
    reason.message += " after " + std::to_string(request.attempts) + (request.attempts == 1 ? " attempt" : " attempts");
    return reason;
  }

  /// Schedules another attempt, or ends the request with the reason.
  void retry(PendingRequest& request, const HttpAnswer& ended, const Error& reason) {
    if (request.attempts >= options_.max_attempts) return finish(request.request, after(request, reason));
    const auto asked = retry_after_s(ended.retry_after, ended.date);
    const double wait = std::min(asked.value_or(request.wait_s * (1 + request.rng.unit())), options_.longest_wait_s);
    request.wait_s *= 2;
    request.not_before = Clock::now() + seconds_long(wait);
    if (asked && ended.status == 429) all_not_before_ = std::max(all_not_before_, request.not_before);
  }

  void finish(std::size_t first, Result<LlmAnswer> answer) {
    std::erase_if(pending_, [&](const PendingRequest& o) { return o.request == first; });
    for (const std::size_t i : duplicates_[first]) {
      answers_[i] = answer;
      if (options_.on_answer) options_.on_answer(i, answer);
      if (answer) answer->cached = true;  // for the equal requests, which cost nothing
    }
  }

  void fail_pending(const std::string& reason) {
    while (!pending_.empty()) finish(pending_.front().request, io_error(reason));
  }

  const LlmEndpoint& endpoint_;
  const std::vector<LlmRequest>& requests_;
  const LlmOptions& options_;
  LlmCache* cache_;
  std::vector<std::optional<Result<LlmAnswer>>> answers_;
  Transport transport_;
  std::vector<PendingRequest> pending_;                         // in request order
  std::map<std::size_t, std::vector<std::size_t>> duplicates_;  // by the first of them
  Clock::time_point all_not_before_{};
  bool server_wants_words_ = false;
};

/// An error that no retry can fix.
std::optional<Error> endpoint_error(const LlmEndpoint& endpoint) {
  const auto usage = [](const std::string& message) {
    return Error{Error::Kind::Usage, "language model", {}, message};
  };
  if (const auto url = chat_url(endpoint.url); !url) return url.error();
  const auto printable = [](char c) { return c > ' ' && c <= '~'; };
  if (!std::all_of(endpoint.key.begin(), endpoint.key.end(), printable))
    return usage("the key contains a space, a control character or a non-ASCII character");
  return std::nullopt;
}

}  // namespace

Result<std::string> chat_url(const std::string& url) {
  const auto scheme = lower(url.substr(0, url.find("://") + 3));
  if ((scheme != "http://" && scheme != "https://") || url.size() == scheme.size())
    return Error{Error::Kind::Usage, "language model", {}, "expected an http:// or https:// url"};
  constexpr std::string_view kEnd = "/chat/completions";
  const auto query = std::min(url.find('?'), url.size());
  auto path = url.substr(0, query);
  while (path.ends_with('/')) path.pop_back();
  if (!path.ends_with(kEnd)) path += kEnd;
  return path + url.substr(query);
}

std::string digest_of(const LlmEndpoint& endpoint, const LlmRequest& request) {
  nlohmann::json shape = {endpoint.url, endpoint.model, request.system, request.user, request.name, request.schema};
  shape.push_back(request.temperature ? number_text(*request.temperature) : "");
  shape.push_back(request.max_tokens ? std::to_string(*request.max_tokens) : "");
  return sha256("unietp-llm/1 " + shape.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

std::string display_text(const LlmRequest& request) {
  return "system:\n" + request.system + "\n\nuser:\n" + request.user + "\n\nform of the answer (" + request.name +
         "):\n" + request.schema + "\n";
}

std::vector<Result<LlmAnswer>> ask_all(const LlmEndpoint& endpoint, const std::vector<LlmRequest>& requests,
                                       const LlmOptions& options, LlmCache* cache) {
  if (const auto wrong = endpoint_error(endpoint)) return std::vector<Result<LlmAnswer>>(requests.size(), *wrong);
  return RequestLoop(endpoint, requests, options, cache).run();
}

LlmTotals totals_of(const std::vector<Result<LlmAnswer>>& answers) {
  LlmTotals totals;
  for (const auto& answer : answers) {
    if (!answer) {
      ++totals.failed;
    } else if (answer->cached) {
      ++totals.cached;
    } else {
      ++totals.asked;
      totals.prompt_tokens += answer->prompt_tokens;
      totals.completion_tokens += answer->completion_tokens;
    }
  }
  return totals;
}

double cost_of(const LlmTotals& totals, const LlmPrice& price) {
  return (static_cast<double>(totals.prompt_tokens) * price.prompt +
          static_cast<double>(totals.completion_tokens) * price.completion) /
         1e6;
}

}  // namespace unietp
