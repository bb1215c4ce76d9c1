#pragma once

#include <string>

#include "core/result.h"
#include "core/rng.h"

namespace unietp {

/// An OpenAI-compatible chat-completions endpoint. The key comes from main as a value; it goes into one header and
/// nowhere else: no error, log or file holds it.
struct LlmEndpoint {
  std::string url;  // whole: "https://api.example.com/v1/chat/completions"
  std::string model;
  std::string key;  // "" for a server that asks for none
  double timeout_s = 60;
  int max_attempts = 5;        // >= 1, of one request
  double first_wait_s = 1;     // before the second attempt; doubles, plus up to as much again by chance
  double longest_wait_s = 60;  // also bounds what Retry-After may ask for
};

/// One exchange. The answer is asked for as a JSON object of one string field.
struct LlmRequest {
  std::string system, user;
  std::string field;  // "instruction"
};

struct LlmAnswer {
  std::string text;  // the field's value
  int prompt_tokens = 0, completion_tokens = 0;
  int attempts = 0;
};

/// Asks once, and again after 429, 5xx, a time-out or a broken connection, waiting as Retry-After says or by doubling
/// waits with jitter from rng. Blocks; safe to call from several threads.
/// Errors: Io (no answer; the last reason, with the status), Schema (an answer that is not what was asked for).
Result<LlmAnswer> ask_llm(const LlmEndpoint& endpoint, const LlmRequest& request, Rng rng);

}  // namespace unietp
