#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace unietp {

/// An OpenAI-compatible chat-completions endpoint. The key comes from main as a value; it goes into one header and
/// nowhere else: no error, log or file holds it, also when the server repeats it.
struct LlmEndpoint {
  std::string url;  // whole: "https://api.example.com/v1/chat/completions"
  std::string model;
  std::string key;  // "" for a server that asks for none
};

/// One exchange, whose answer is a JSON object. Everything here, the url and the model shape the answer.
struct LlmRequest {
  std::string system, user;
  std::string name;    // of the schema: letters, digits, `_` and `-`
  std::string schema;  // JSON schema of the answer as text, an object at its top
  std::optional<double> temperature;
  std::optional<int> max_tokens;
  bool operator==(const LlmRequest&) const = default;
};

/// A model's answer to one request.
struct LlmAnswer {
  std::string text;  // one JSON object, as the model wrote it; not checked against the schema
  std::int64_t prompt_tokens = 0, completion_tokens = 0;  // as the server counts, over all attempts that it answered
  int attempts = 0;                                       // requests sent for it; as first asked when cached
  bool cached = false;
};

}  // namespace unietp
