#pragma once

#include <string>
#include <vector>

#include "cli/commands.h"
#include "core/result.h"
#include "run/shard.h"

namespace unietp {

class CommandOption;

/// Names as the command line accepts them.
std::vector<std::string> simulator_names();
std::vector<std::string> split_names();

/// Adds an option for a list of simulators; parse_simulators reads its value.
CommandOption* add_simulators_option(CommandParser& command, std::string& target, const std::string& help,
                                     const std::string& name = "--simulators");
/// Adds the argument SIMULATOR.
CommandOption* add_simulator_argument(CommandParser& command, std::string& target, const std::string& help);
/// The value of an option `--shard`, "2/8", as part 2 of 8. Errors: Usage.
Result<Shard> parse_shard(const std::string& text);
/// Adds --threads and sets its default.
void add_threads_option(CommandParser& command, int& threads, const CommandLine& program);

}  // namespace unietp
