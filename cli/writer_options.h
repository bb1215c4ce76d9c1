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
  std::string writer = "grammar", phrasings = "everyday", english;  // english "": as it is
  std::filesystem::path batch;                                      // folder of request and answer files
  int rewrites = 2;
  bool stand_in = false;
  LlmChoice llm;
};

/// Adds --writer, --phrasings, --english, --batch, --rewrites, --stand-in and the options of a language model.
void add_writer_options(CommandParser& command, WriterChoice& choice);

/// The phrasings of a choice. Errors: Usage for an unknown name or a missing option.
Result<Phrasings> check_writer(const WriterChoice& choice);
/// The English of a choice that `check_writer` accepts; nullopt where none is named.
std::optional<English> english_of(const WriterChoice& choice);

/// Which instructions are rewritten, and from where to where.
struct RewordRequest {
  std::filesystem::path folder, out;
  std::optional<std::uint64_t> seed;
  bool paired = false, contrasts = false, replace_human = false;
  int wordings = 0;  // different texts of each task's goal; 0: not asked for
};

/// Rewrites the instructions of a data set and prints a summary. Exit::Wrong when answers are still missing; the data
/// set is then as it was, unless the grammar may stand in.
Exit reword_dataset(const RewordRequest& request, const Resources& resources, const WriterChoice& choice,
                    const CommandLine& program);

}  // namespace unietp
