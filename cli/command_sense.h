#pragma once

#include <filesystem>

#include "cli/commands.h"
#include "sense/common_sense.h"
#include "sense/word_kinds.h"

namespace unietp {

// Each adds a subcommand of `unietp knowledge`.
void add_sense_fit_command(CommandParser& knowledge, CommandLine& program);
void add_sense_measure_command(CommandParser& knowledge, CommandLine& program);

/// Where the tables of what people do with things are.
std::filesystem::path sense_folder(const CommandLine& program);

}  // namespace unietp
