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

struct LlmOptions {
  int at_once = 4;                          // requests under way, >= 1
  double attempt_s = 120;                   // of one attempt, from the connection to the last byte
  double total_s = 3600;                    // of the whole call; what is unanswered then is an error
  int max_attempts = 5;                     // >= 1, of one request
  double first_wait_s = 1;                  // before the second attempt; doubles, plus up to as much again by chance
  double longest_wait_s = 60;               // also bounds what Retry-After may ask for
  std::uint64_t seed = 0;                   // of the chance in the waits
  const std::atomic<bool>* stop = nullptr;  // when it turns true, what is under way is given up
  /// Called from the asking thread as each request ends, in the order of arrival; cached answers first.
  std::function<void(std::size_t request, const Result<LlmAnswer>& answer)> on_answer;
};

/// The url of an OpenAI-compatible server made whole: ".../v1" gets "/chat/completions". Errors: Usage, when it is no
/// http or https url.
Result<std::string> chat_url(const std::string& url);

/// SHA-256 of everything that shapes the answer: url, model, prompts, schema, parameters; not the key.
std::string digest_of(const LlmEndpoint& endpoint, const LlmRequest& request);

/// What is sent, as people read it; the key is no part of it.
std::string shown(const LlmRequest& request);

/// Asks all, many at once; equal requests are asked once. Gives the answers in the order of the requests, whatever the
/// order of arrival. `cache` may be null; what it holds is not asked, and each new answer is kept there at once.
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

/// What a call cost. Tokens are those of answers that came now; cached ones are free.
struct LlmTotals {
  int asked = 0, cached = 0, failed = 0;  // requests
  std::int64_t prompt_tokens = 0, completion_tokens = 0;
};
LlmTotals totals_of(const std::vector<Result<LlmAnswer>>& answers);

/// Prices for a million tokens, in any currency.
struct LlmPrice {
  double prompt = 0, completion = 0;
};
double cost_of(const LlmTotals& totals, const LlmPrice& price);

}  // namespace unietp
