#include "cli/completion.h"

#include <algorithm>

namespace unietp {
namespace {

void add_below(const CommandPage& page, const std::vector<OptionPage>& shared, std::vector<CompletedCommand>& all) {
  CompletedCommand command{&page, page.name.substr(page.name.rfind(' ') + 1), {}, {}, {}};
  for (const auto& option : page.options) {
    if (!option.argument) {
      command.options.push_back(option);
      continue;
    }
    command.words.insert(command.words.end(), option.choices.begin(), option.choices.end());
    if (option.completes == OptionPage::Completes::File || command.paths == OptionPage::Completes::Nothing)
      command.paths = option.completes;
  }
  command.options.insert(command.options.end(), shared.begin(), shared.end());
  for (const auto& below : page.commands) command.words.push_back(below.name.substr(below.name.rfind(' ') + 1));
  all.push_back(std::move(command));
  for (const auto& below : page.commands) add_below(below, shared, all);
}

}  // namespace

std::vector<CompletedCommand> completed_commands(const CommandPage& program, const std::vector<std::string>& topics) {
  OptionPage help;
  help.names = {"--help"};
  help.help = "Explain the command";
  std::vector<OptionPage> shared = program.options;  // may stand after every command
  std::erase_if(shared, [](const OptionPage& option) { return option.names.front() == "--version"; });
  shared.push_back(help);
  std::vector<CompletedCommand> all;
  for (const auto& command : program.commands) add_below(command, shared, all);
  CompletedCommand top{&program, program.name, program.options, {}, {}};
  top.options.push_back(help);
  for (const auto& command : all) {
    if (command.page->name == program.name + " " + command.word) top.words.push_back(command.word);
  }
  for (auto& command : all) {
    if (command.page->name != program.name + " help") continue;
    command.words = top.words;
    command.words.insert(command.words.end(), topics.begin(), topics.end());
  }
  all.insert(all.begin(), std::move(top));
  return all;
}

bool takes_commas(const OptionPage& option) { return option.value.find(",...") != std::string::npos; }

}  // namespace unietp
