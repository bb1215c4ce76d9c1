#pragma once

#include <string>

#include "cli/commands.h"
#include "cli/writer_options.h"
#include "run/run.h"

namespace unietp {

/// The options that all commands for making data sets share.
struct RunCommand {
  RunConfiguration configuration;
  RunOptions run;
  std::string sense;  // at least; empty: that of the configuration
  std::string shard;  // "2/8"; empty: all of it
  WriterChoice writer;
  bool json = false;
};

/// The settings of a configuration file. Makes `program` load the extended library if they ask for it. Errors: those of
/// read_configuration; Usage for given scenes, bindings and the user's own templates, which only `unietp generate`
/// takes.
Result<RunConfiguration> settings_in(const std::filesystem::path& file, CommandLine& program);

/// Adds `--out`, `--threads`, `--resume`, `--shard`, `--json` and those of the writer of instructions.
void add_run_options(CommandParser& app, RunCommand& command, const CommandLine& program);

/// Makes the data set with a progress line, rewords it if asked to, and prints a report.
Exit make_data_set(RunCommand& command, const Resources& resources, const CommandLine& program);

}  // namespace unietp
