#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "core/result.h"
#include "evaluation/evaluate.h"
#include "evaluation/evaluation_manifest.h"
#include "evaluation/model_policy.h"

namespace unietp {

class CommandParser;

/// The options of `unietp evaluate` as they were given.
struct EvaluateChoice {
  std::filesystem::path folder, out, cache;
  std::string model, url, policy;
  std::string backend = kOwnBackend;
  std::string modes = "M1", splits, simulators, tasks, preset = "paper";
  int limit = 0, repeats = 1, at_once = 0, report_pictures = kReportPictures;
  std::optional<std::uint64_t> seed;
  bool resume = false, dry_run = false;
  std::string show_prompt;  // "TASK:STEP"

  std::string history = "full", images = "current", boxes, feedback = "full", box_form, prompt = "unietp",
              chat = "single";
  std::vector<std::string> settings;  // "steps=60"
  bool reasoning = false, structured = false;

  double temperature = -1, top_p = -1;
  int max_tokens = 0;
  std::optional<std::uint64_t> sampling_seed;
  std::string extra = "{}";
  double attempt_s = 120, first_wait_s = 1, price_in = 0, price_out = 0, max_cost = 0;
  int attempts = 8;
};

/// Adds the options to the command.
void add_evaluate_options(CommandParser& command, EvaluateChoice& choice);

/// What the options ask for, read and checked.
struct EvaluateRequest {
  EpisodeSelection selection;
  std::map<Mode, Settings> settings;
  std::optional<ModelOptions> model;  // exactly one of the three
  std::optional<BuiltInPolicy> built_in;
  std::optional<std::vector<std::string>> program;  // and its arguments
  int at_once = 1;
};
/// Errors: Usage, naming the option; those of the prompt's file.
Result<EvaluateRequest> read_evaluate_options(const EvaluateChoice& choice, const CommandLine& program);

}  // namespace unietp
