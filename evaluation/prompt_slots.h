#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "environment/environment.h"
#include "evaluation/evaluation_manifest.h"
#include "evaluation/prompt_file.h"

namespace unietp {

/// A step of the episode so far, as the agent knows it.
struct PastStep {
  std::string reply;                  // its own
  std::vector<ActionReport> results;  // of its actions, as far as the settings tell
};

/// What the slots of a prompt are filled from.
struct PromptContext {
  const Environment* environment = nullptr;
  const TalkSettings* talk = nullptr;
  const std::vector<PastStep>* past = nullptr;
  std::size_t pictures = 0;  // sent with this turn
};

/// A slot: its name and what it holds.
struct PromptSlot {
  std::string_view name, meaning;
};
/// All of them, in the order of docs/evaluation.md.
std::vector<PromptSlot> prompt_slots();
std::vector<std::string> prompt_slot_names();

/// The text with its slots filled, without line ends at its end. Equal contexts give equal bytes. What is filled in is
/// not searched for slots again.
std::string filled(const std::vector<PromptLine>& lines, const PromptContext& context);

}  // namespace unietp
