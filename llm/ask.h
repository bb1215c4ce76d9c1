#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "llm/exchange.h"

namespace unietp {

class LlmCache;

/// Limits and retries of `ask_all`.
struct LlmOptions {
  int at_once = 4;          // concurrent requests, >= 1
  double attempt_s = 120;   // of one attempt, from the connection to the last byte
  double total_s = 3600;    // of the whole call; requests without an answer by then fail
  int max_attempts = 5;     // >= 1, of one request
  double first_wait_s = 1;  // before the second attempt; doubles each time, plus a random part of the same size at most
  double longest_wait_s = 60;               // also an upper bound for Retry-After
  std::uint64_t seed = 0;                   // of the random part of the waits
  const std::atomic<bool>* stop = nullptr;  // when true, requests in progress are abandoned
  /// Called from the thread of `ask_all` as each request ends, in the order of arrival; cached answers first.
  std::function<void(std::size_t request, const Result<LlmAnswer>& answer)> on_answer;
};

/// The complete url of an OpenAI-compatible server: ".../v1" gets "/chat/completions". Errors: Usage, when it is no
/// http or https url.
Result<std::string> chat_url(const std::string& url);

/// SHA-256 of everything that shapes the answer: url, model, prompts, schema, parameters; not the key.
std::string digest_of(const LlmEndpoint& endpoint, const LlmRequest& request);

/// The request for display, without the key.
std::string display_text(const LlmRequest& request);

/// Sends all requests, several at a time; equal requests are sent once. Returns the answers in the order of the
/// requests. `cache` may be null; requests that it has are not sent, and each new answer is stored in it at once.
///
/// Tried again: 408, 425, 429, 5xx, time-outs, broken connections, cut or oversized bodies, and answers without a JSON
/// object; after waits as Retry-After says (seconds or a date) or doubling ones with jitter. A 429 with Retry-After
/// holds back new requests too. A server that refuses `response_format` (400, 422) or answers without a JSON object is
/// asked in words, and the object is taken out of its text.
///
/// Ends after total_s at the latest. Errors of single requests: Io (no answer: the last reason, with the status and
/// what the server said, the key made unreadable; stopped; out of time), Schema (an answer that is not what was asked
/// for). Deterministic as far as the endpoint is. Blocks; safe to call from several threads with a cache for each.
std::vector<Result<LlmAnswer>> ask_all(const LlmEndpoint& endpoint, const std::vector<LlmRequest>& requests,
                                       const LlmOptions& options, LlmCache* cache);

/// Requests and tokens of a call. Tokens of cached answers are not counted.
struct LlmTotals {
  int asked = 0, cached = 0, failed = 0;  // requests
  std::int64_t prompt_tokens = 0, completion_tokens = 0;
};
/// Sums over the answers of a call.
LlmTotals totals_of(const std::vector<Result<LlmAnswer>>& answers);

/// Prices per million tokens, in any currency.
struct LlmPrice {
  double prompt = 0, completion = 0;
};
/// In the currency of the price.
double cost_of(const LlmTotals& totals, const LlmPrice& price);

}  // namespace unietp
