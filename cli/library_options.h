#pragma once

#include "cli/commands.h"

namespace unietp {

/// Adds `--templates` and `--extended`, which add templates to the default library.
void add_library_options(CommandParser& command, CommandLine& program);

}  // namespace unietp
