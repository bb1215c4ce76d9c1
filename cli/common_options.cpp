#include "cli/common_options.h"

#include <charconv>

#include "cli/command_parser.h"
#include "core/limits.h"
#include "dataset/configuration.h"
#include "scene/simulator.h"

namespace unietp {

std::vector<std::string> simulator_names() {
  std::vector<std::string> names;
  for (const auto simulator : kSimulators) names.emplace_back(name_of(simulator));
  return names;
}

std::vector<std::string> split_names() {
  std::vector<std::string> names;
  for (const auto split : all_splits()) names.emplace_back(name_of(split));
  return names;
}

CommandOption* add_simulators_option(CommandParser& command, std::string& target, const std::string& help,
                                     const std::string& name) {
  return command.add_option(name, target, help)->type_name("NAME,...")->suggests(simulator_names());
}

CommandOption* add_simulator_argument(CommandParser& command, std::string& target, const std::string& help) {
  return command.add_option("SIMULATOR", target, help)->suggests(simulator_names());
}

Result<Shard> parse_shard(const std::string& text) {
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, shard.number);
  const bool slash = number.ec == std::errc{} && number.ptr != end && *number.ptr == '/';
  const auto of = slash ? std::from_chars(number.ptr + 1, end, shard.of) : number;
  if (!slash || of.ec != std::errc{} || of.ptr != end || shard.number < 1 || shard.number > shard.of)
    return Error{Error::Kind::Usage, "--shard", {}, "expected K/N with 1 <= K <= N, such as 2/8, not \"" + text + "\""};
  return shard;
}

void add_threads_option(CommandParser& command, int& threads, const CommandLine& program) {
  threads = program.processors;
  command.add_option("--threads", threads, "Threads (default: one per processor); never changes the result")
      ->within(1, limits::kThreads);
}

}  // namespace unietp
