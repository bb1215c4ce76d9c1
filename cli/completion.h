#pragma once

#include <string>
#include <vector>

#include "cli/command_page.h"

namespace unietp {

// Scripts that make a shell complete the program's commands, options and values. `topics`: further words for the
// command `help`.
std::string bash_completion(const CommandPage& program, const std::vector<std::string>& topics);
std::string zsh_completion(const CommandPage& program, const std::vector<std::string>& topics);
std::string fish_completion(const CommandPage& program, const std::vector<std::string>& topics);

/// A command of the tree with the words that may follow it.
struct CompletedCommand {
  const CommandPage* page = nullptr;
  std::string word;                                              // the last word of its name
  std::vector<OptionPage> options;                               // its own, then those of the program; with --help
  std::vector<std::string> words;                                // subcommands, values of arguments, topics of `help`
  OptionPage::Completes paths = OptionPage::Completes::Nothing;  // what its arguments complete
};
/// Every command of the tree, the program first, each before its subcommands.
std::vector<CompletedCommand> completed_commands(const CommandPage& program, const std::vector<std::string>& topics);

/// Whether an option takes a list with commas, such as "NAME,...".
bool takes_commas(const OptionPage& option);

}  // namespace unietp
