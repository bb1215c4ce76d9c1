#pragma once

#include <atomic>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "evaluation/policy.h"

namespace unietp {

/// How a program acts in episodes. It is sent a line of JSON-RPC 2.0 for each reply that is wanted and answers with one
/// line (docs/evaluation.md):
///   {"jsonrpc": "2.0", "id": 1, "method": "begin", "params": {"task", "mode", "repeat", "seed", "prompt",
///    "observation", "text", "picture"}}
///   {"jsonrpc": "2.0", "id": 2, "method": "act", "params": {"observation", "text", "picture"}}
///   {"jsonrpc": "2.0", "id": 2, "result": {"action": "go_to(mug_1)"}}
struct ProgramOptions {
  std::vector<std::string> arguments;  // the program and its arguments
  double reply_s = 120;                // the longest that a reply may take
  bool pictures = false;               // send what the camera shows, as PNG in base64
  std::uint64_t seed = 0;
  const std::atomic<bool>* stop = nullptr;
};

/// Each thread starts a program of its own, and anew when it has ended. An action may be text or JSON; whatever it says
/// is its reply. A line that is no answer, an error in the place of the result, and a program that ends or takes too
/// long have no reply: the episode may be begun again.
PolicyMaker program_policies(ProgramOptions options);

/// "python:my.module.Agent" as the arguments of a program that makes the class and calls its `act(observation)`, and
/// `begin(episode)` if it has one. Errors: Usage, for a text that names no class.
Result<std::vector<std::string>> python_policy(const std::string& text);

/// Reads a program's answer to the call `id`. Errors: Schema.
Result<PolicyReply> read_policy_answer(std::string_view line, int id);

}  // namespace unietp
