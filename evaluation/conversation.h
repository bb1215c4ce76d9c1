#pragma once

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "core/result.h"
#include "environment/environment.h"
#include "evaluation/evaluation_manifest.h"
#include "evaluation/prompt_slots.h"
#include "llm/chat_request.h"

namespace unietp {

/// What a model is told in one episode, step by step. The prompt and the settings must outlive it. Deterministic: equal
/// tasks, settings and replies give equal turns, bit for bit.
class Conversation {
 public:
  Conversation(const PromptFile& prompt, const TalkSettings& talk) : prompt_(&prompt), talk_(&talk) {}

  /// The turns that are sent for the present step. Errors: Io, when the picture cannot be made.
  Result<std::vector<ChatTurn>> turns(const Environment& environment);
  /// Takes in what the model answered to them, before the environment is stepped.
  void answered(std::string reply);

 private:
  using SharedPicture = std::shared_ptr<const std::string>;
  Result<Done> see(const Environment& environment);
  ChatTurn present_turn(const Environment& environment) const;

  const PromptFile* prompt_;
  const TalkSettings* talk_;
  std::string system_;
  std::string task_;                     // told again where the first turn is left out
  std::vector<PastStep> past_;           // the results of the last one come with the next observation
  std::vector<std::string> user_turns_;  // the user's turn of each step, in a chat of several turns
  std::deque<SharedPicture> pictures_;   // the last ones, as many as are sent
};

/// The turns as text for people; a picture is `[picture, 12345 bytes]`.
std::string display_text(const std::vector<ChatTurn>& turns);

}  // namespace unietp
