#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "annotator/instruction.h"
#include "cli/commands.h"
#include "cli/llm_options.h"

namespace unietp {

/// Who writes the instructions, as given on the command line.
struct WriterChoice {
  std::string writer = "grammar", phrasings = "all";
  std::filesystem::path batch;  // folder of request and answer files
  int rewrites = 2;
  LlmChoice llm;
};

/// Adds --writer, --phrasings, --batch, --rewrites and the options of a language model.
void add_writer_options(CommandParser& command, WriterChoice& choice);

/// The phrasings of a choice. Errors: Usage for an unknown name or a missing option.
Result<Phrasings> check_writer(const WriterChoice& choice);

/// Rewrites the instructions of a data set and prints a summary. Exit::Wrong when answers are still missing.
Exit reword_dataset(const std::filesystem::path& folder, const std::filesystem::path& out, const Resources& resources,
                    const WriterChoice& choice, std::optional<std::uint64_t> seed, bool paired,
                    const CommandLine& program);

}  // namespace unietp
