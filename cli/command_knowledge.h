#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "akb/facts.h"
#include "cli/commands.h"

namespace unietp {

// Each adds a subcommand of `unietp knowledge`.
void add_knowledge_show_command(CommandParser& knowledge, CommandLine& program);
void add_knowledge_stats_command(CommandParser& knowledge, CommandLine& program);
void add_knowledge_why_command(CommandParser& knowledge, CommandLine& program);
void add_knowledge_diff_command(CommandParser& knowledge, CommandLine& program);
void add_knowledge_complete_command(CommandParser& knowledge, CommandLine& program);
void add_sense_fit_command(CommandParser& knowledge, CommandLine& program);
void add_sense_measure_command(CommandParser& knowledge, CommandLine& program);

/// The knowledge bases of some simulators, compiled first if necessary. Adds those of compiled_knowledge to `errors`.
std::vector<Knowledge> load_some(const CommandLine& program, const std::vector<Simulator>& simulators,
                                 std::vector<Error>& errors);

/// Errors: Usage with the nearest name.
Result<const Category*> category_named(const Knowledge& knowledge, std::string_view name);

/// To stdout, with a line feed.
void print_line(const std::string& text);
/// "[curated, confidence 0.8]"
std::string source_text(const Source& source);
/// As the schemas knowledge-show and knowledge-why have it.
nlohmann::ordered_json json_of(const Fact& fact);

/// Prints the number of facts of each simulator, one line each.
Exit print_sizes(const CommandLine& program);

}  // namespace unietp
