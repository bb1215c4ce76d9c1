#pragma once

#include <filesystem>
#include <string>

#include "llm/ask.h"

namespace unietp {

class CommandParser;

/// How a command reaches a language model.
struct LlmChoice {
  std::string url, model;
  std::filesystem::path cache;  // "": in the program's cache folder
  LlmOptions ask;
  LlmPrice price;
  double temperature = -1;  // sent when it is not negative
  int max_tokens = 0;       // sent when it is positive
  bool dry_run = false;
};

/// Adds --llm-url, --llm-model and the rest to a command. `required`: the first two must be given.
void add_llm_options(CommandParser& command, LlmChoice& choice, bool required);

/// "tokens     120 in, 44 out, cost 0.01"
std::string cost_line(const LlmTotals& totals, const LlmPrice& price);

}  // namespace unietp
