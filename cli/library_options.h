#pragma once

#include "cli/commands.h"

namespace unietp {

/// Adds `--templates DIR` and `--extended`: which templates a command works with, besides the default library.
void add_library_options(CommandParser& command, CommandLine& program);

}  // namespace unietp
