#pragma once

#include <string>
#include <vector>

#include "llm/ask.h"
#include "server.h"

namespace unietp::test {

inline constexpr const char* kKey = "sk-very-secret-0123456789";

inline LlmEndpoint endpoint_of(const ChatServer& server) { return {server.url, "tiny", kKey}; }

/// Waits of milliseconds, so that tests are quick; patience enough for a busy machine.
inline LlmOptions quick() {
  LlmOptions options;
  options.attempt_s = 20;
  options.total_s = 60;
  options.max_attempts = 3;
  options.first_wait_s = 0.001;
  options.longest_wait_s = 0.002;
  return options;
}

inline LlmRequest question(int number) {
  return {"Be brief.", "question " + std::to_string(number), "answer", R"({"type":"object"})", {}, {}};
}

inline std::vector<LlmRequest> questions(int count) {
  std::vector<LlmRequest> all;
  for (int i = 0; i < count; ++i) all.push_back(question(i));
  return all;
}

/// `{"to": "question 3"}` in a chat completion.
inline std::string answer_to(const Received& received) { return completion("{\"to\": \"" + received.user + "\"}"); }
inline std::string text_for(int number) { return "{\"to\": \"question " + std::to_string(number) + "\"}"; }

}  // namespace unietp::test
