#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "akb/facts.h"
#include "cli/commands.h"

namespace unietp {

// Each adds one subcommand of `unietp knowledge`.
void add_knowledge_show_command(CommandParser& knowledge, CommandLine& program);
void add_knowledge_stats_command(CommandParser& knowledge, CommandLine& program);
void add_knowledge_why_command(CommandParser& knowledge, CommandLine& program);
void add_knowledge_diff_command(CommandParser& knowledge, CommandLine& program);
void add_knowledge_complete_command(CommandParser& knowledge, CommandLine& program);

/// The knowledge bases of some simulators, compiled first where they are not. `errors` as of compiled_knowledge.
std::vector<Knowledge> load_some(const CommandLine& program, const std::vector<Simulator>& simulators,
                                 std::vector<Error>& errors);

/// Errors: Usage with the nearest name.
Result<const Category*> category_named(const Knowledge& knowledge, std::string_view name);

void print_line(const std::string& text);
/// "[curated, confidence 0.8]"
std::string told(const Source& source);
nlohmann::ordered_json json_of(const Fact& fact);

/// How much is known of each simulator, a line each; what `import` ends with.
Exit print_sizes(const CommandLine& program);

}  // namespace unietp
