#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "annotator/instruction.h"
#include "cli/commands.h"
#include "cli/llm_options.h"

namespace unietp {

/// Who writes the instructions, as a command line says it.
struct WriterChoice {
  std::string writer = "grammar", phrasings = "all";
  std::filesystem::path batch;  // folder of request and answer files
  int rewrites = 2;
  LlmChoice llm;
};

/// Adds --writer, --phrasings, --batch, --rewrites and the options of a language model.
void add_writer_options(CommandParser& command, WriterChoice& choice);

/// What is missing or unknown, as a Usage error; the choice's phrasings otherwise.
Result<Phrasings> settled(const WriterChoice& choice);

/// Writes the instructions of a data set anew and tells what came of it. Exit::Wrong when answers are still missing.
Exit write_anew(const std::filesystem::path& folder, const std::filesystem::path& out, const Resources& resources,
                const WriterChoice& choice, std::optional<std::uint64_t> seed, bool paired, const CommandLine& program);

}  // namespace unietp
