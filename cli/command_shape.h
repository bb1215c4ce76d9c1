#pragma once

#include "cli/commands.h"

namespace unietp {

void add_shape_command(CommandParser& app, CommandLine& program);  // as in cli/commands.h

}  // namespace unietp
