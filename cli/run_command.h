#pragma once

#include <string>

#include "cli/commands.h"
#include "cli/writer_options.h"
#include "run/run.h"

namespace unietp {

/// What the commands that make a data set share: what of, where, by how many threads, which part, how it is told.
struct RunCommand {
  RunConfiguration configuration;
  RunOptions run;
  std::string shard;  // "2/8"; empty: all of it
  WriterChoice writer;
  bool json = false;
};

/// The settings of a file for a run with the built-in templates in homes of its own; sets `program` to load what they
/// need. Errors: those of read_configuration; Usage for given scenes and for templates of a person's own, which only
/// `unietp generate` takes.
Result<RunConfiguration> settings_in(const std::filesystem::path& file, CommandLine& program);

/// Adds `--out`, `--threads`, `--resume`, `--shard`, `--json` and those of the writer of instructions.
void add_run_options(CommandParser& app, RunCommand& command, const CommandLine& program);

/// Makes the data set with a progress line, and says what came of it.
Exit make_data_set(RunCommand& command, const Resources& resources, const CommandLine& program);

}  // namespace unietp
