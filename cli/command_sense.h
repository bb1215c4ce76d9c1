#pragma once

#include <filesystem>
#include <memory>

#include "cli/commands.h"
#include "sense/common_sense.h"
#include "sense/word_kinds.h"

namespace unietp {

// Each adds a subcommand of `unietp sense`, which sets `ran` before it runs.
void add_sense_fit_command(CommandParser& sense, CommandLine& program, std::shared_ptr<bool> ran);
void add_sense_measure_command(CommandParser& sense, CommandLine& program, std::shared_ptr<bool> ran);

/// Where the tables of what people do with things are.
std::filesystem::path sense_folder(const CommandLine& program);

}  // namespace unietp
