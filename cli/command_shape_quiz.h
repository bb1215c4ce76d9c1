#pragma once

#include "cli/command_parser.h"
#include "cli/commands.h"

namespace unietp {

void add_shape_quiz_command(CommandParser& shape, CommandLine& program);  // `unietp shape quiz`

}  // namespace unietp
