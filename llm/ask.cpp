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

namespace unietp {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double kLongestPoll_s = 0.1;  // how late a stop may be noticed

Clock::duration duration_of(double seconds) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(std::clamp(seconds, 0.0, 1e8)));
}

Error io_error(const std::string& message) { return {Error::Kind::Io, "language model", {}, message}; }

/// A request that is not answered yet.
struct Open {
  std::size_t request = 0;  // the first of its equals
  std::string digest;
  int attempts = 0;
  bool in_words = false;      // asked without response_format
  bool refused_form = false;  // the server answered 400 or 422 while asked with it
  double wait_s = 0;
  Rng rng{0};
  LlmAnswer spent;  // tokens of attempts whose answers could not be used
  Clock::time_point not_before{};
  bool under_way = false;
};

class Asking {
 public:
  Asking(const LlmEndpoint& endpoint, const std::vector<LlmRequest>& requests, const LlmOptions& options,
         LlmCache* cache)
      : endpoint_(endpoint),
        requests_(requests),
        options_(options),
        cache_(cache),
        answers_(requests.size()),
        transport_(endpoint, std::min(options.attempt_s, options.total_s)) {}

  std::vector<Result<LlmAnswer>> run() {
    const auto end = Clock::now() + duration_of(options_.total_s);
    open_those_not_cached();
    while (!open_.empty()) {
      if (options_.stop != nullptr && *options_.stop) {
        give_up("stopped before an answer arrived");
        break;
      }
      const auto now = Clock::now();
      if (now >= end) {
        give_up("no answer within " + number_text(options_.total_s) + " s for all requests");
        break;
      }
      start_those_ready(now);
      const double pause =
          std::min(kLongestPoll_s, std::chrono::duration<double>(std::min(next_event(), end) - now).count());
      for (auto& ended : transport_.wait(std::max(pause, 0.001))) take(std::move(ended));
    }
    std::vector<Result<LlmAnswer>> all;
    all.reserve(answers_.size());
    for (auto& answer : answers_) all.push_back(std::move(*answer));
    return all;
  }

 private:
  void open_those_not_cached() {
    std::map<std::string, std::size_t> first;
    for (std::size_t i = 0; i < requests_.size(); ++i) {
      const auto digest = digest_of(endpoint_, requests_[i]);
      const auto [at, is_new] = first.emplace(digest, i);
      equals_[at->second].push_back(i);
      if (!is_new) continue;
      Open request;
      request.request = i;
      request.digest = digest;
      request.wait_s = options_.first_wait_s;
      request.rng = Rng(options_.seed).fork("llm wait", i);
      open_.push_back(std::move(request));
    }
    if (cache_ == nullptr) return;
    for (const auto& request : std::vector<Open>(open_)) {
      auto kept = cache_->find(request.digest);
      if (kept && json_object_in(kept->text)) finish(request.request, std::move(*kept));
    }
  }

  void start_those_ready(Clock::time_point now) {
    if (now < all_not_before_) return;
    for (auto& request : open_) {
      if (transport_.under_way() >= std::max(1, options_.at_once)) return;
      if (request.under_way || now < request.not_before) continue;
      request.under_way = true;
      ++request.attempts;
      const bool in_words = request.in_words || server_wants_words_;
      request.in_words = in_words;
      transport_.start(request.request, chat_body(endpoint_, requests_[request.request],
                                                  in_words ? LlmForm::Words : LlmForm::ResponseFormat));
    }
  }

  Clock::time_point next_event() const {
    auto next = Clock::time_point::max();
    for (const auto& request : open_) {
      if (!request.under_way) next = std::min(next, std::max(request.not_before, all_not_before_));
    }
    return next;
  }

  void take(HttpAnswer ended) {
    const auto at = std::find_if(open_.begin(), open_.end(), [&](const Open& o) { return o.request == ended.id; });
    Open& request = *at;
    request.under_way = false;
    if (!ended.failure.empty()) return again(request, ended, io_error("no answer: " + ended.failure));
    if (ended.status >= 200 && ended.status < 300) return take_completion(request, ended);
    const bool refuses_form = (ended.status == 400 || ended.status == 422) && !request.in_words;
    if (refuses_form) {
      request.in_words = true;
      request.refused_form = true;
      --request.attempts;
      return;
    }
    auto message = "no answer: status " + std::to_string(ended.status);
    const auto complaint = complaint_in(ended.body, endpoint_.key);
    if (!complaint.empty()) message += ", \"" + complaint + "\"";
    const bool passes = ended.status == 408 || ended.status == 425 || ended.status == 429 || ended.status >= 500;
    if (passes) return again(request, ended, io_error(message));
    finish(request.request, after(request, io_error(message)));
  }

  void take_completion(Open& request, const HttpAnswer& ended) {
    auto read = read_completion(ended.body, endpoint_.key);
    if (!read) {
      const LlmAnswer usage = usage_in(ended.body);
      request.spent.prompt_tokens += usage.prompt_tokens;
      request.spent.completion_tokens += usage.completion_tokens;
      request.in_words = true;  // a server may ignore response_format
      return again(request, ended, read.error());
    }
    if (request.refused_form) server_wants_words_ = true;  // it was the form that it refused, not the request
    read->prompt_tokens += request.spent.prompt_tokens;
    read->completion_tokens += request.spent.completion_tokens;
    read->attempts = request.attempts;
    if (cache_ != nullptr) cache_->keep(request.digest, endpoint_.model, *read);
    finish(request.request, std::move(*read));
  }

  static Error after(const Open& request, Error reason) {
    reason.message += " after " + std::to_string(request.attempts) + (request.attempts == 1 ? " attempt" : " attempts");
    return reason;
  }

  /// Waits and tries once more, or ends the request with the reason.
  void again(Open& request, const HttpAnswer& ended, const Error& reason) {
    if (request.attempts >= options_.max_attempts) return finish(request.request, after(request, reason));
    const auto asked = retry_after_s(ended.retry_after, ended.date);
    const double wait = std::min(asked.value_or(request.wait_s * (1 + request.rng.unit())), options_.longest_wait_s);
    request.wait_s *= 2;
    request.not_before = Clock::now() + duration_of(wait);
    if (asked && ended.status == 429) all_not_before_ = std::max(all_not_before_, request.not_before);
  }

  void finish(std::size_t first, Result<LlmAnswer> answer) {
    std::erase_if(open_, [&](const Open& o) { return o.request == first; });
    for (const std::size_t i : equals_[first]) {
      answers_[i] = answer;
      if (options_.on_answer) options_.on_answer(i, answer);
      if (answer) answer->cached = true;  // for its equals, which cost nothing more
    }
  }

  void give_up(const std::string& reason) {
    while (!open_.empty()) finish(open_.front().request, io_error(reason));
  }

  const LlmEndpoint& endpoint_;
  const std::vector<LlmRequest>& requests_;
  const LlmOptions& options_;
  LlmCache* cache_;
  std::vector<std::optional<Result<LlmAnswer>>> answers_;
  Transport transport_;
  std::vector<Open> open_;                                  // in request order
  std::map<std::size_t, std::vector<std::size_t>> equals_;  // by the first of them
  Clock::time_point all_not_before_{};
  bool server_wants_words_ = false;
};

/// What no attempt could mend.
std::optional<Error> wrong_with(const LlmEndpoint& endpoint) {
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

std::string shown(const LlmRequest& request) {
  return "system:\n" + request.system + "\n\nuser:\n" + request.user + "\n\nform of the answer (" + request.name +
         "):\n" + request.schema + "\n";
}

std::vector<Result<LlmAnswer>> ask_all(const LlmEndpoint& endpoint, const std::vector<LlmRequest>& requests,
                                       const LlmOptions& options, LlmCache* cache) {
  if (const auto wrong = wrong_with(endpoint)) return std::vector<Result<LlmAnswer>>(requests.size(), *wrong);
  return Asking(endpoint, requests, options, cache).run();
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
