#include <cstdio>
#include <memory>

#include "cli/command_parser.h"
#include "cli/commands.h"
#include "cli/completion.h"
#include "cli/help_text.h"
#include "cli/help_topics.h"
#include "cli/man_page.h"
#include "core/text.h"
#include "core/unknown_name.h"
#include "core/version.h"

namespace unietp {
namespace {

struct HelpOptions {
  std::vector<std::string> words;
  bool man = false;
};

/// The part of a command's name after its parent's.
std::string last_word(const std::string& name) { return name.substr(name.rfind(' ') + 1); }

/// The command that the words name below `page`; nullptr when there is none.
const CommandPage* find_command(const CommandPage& page, const std::vector<std::string>& words) {
  const CommandPage* found = &page;
  for (const auto& word : words) {
    const CommandPage* next = nullptr;
    for (const auto& command : found->commands) {
      if (last_word(command.name) == word) next = &command;
    }
    if (next == nullptr) return nullptr;
    found = next;
  }
  return found;
}

Exit help(const HelpOptions& options, const CommandParser& app) {
  const CommandPage program = app.page();
  if (options.man) {
    std::fputs(man_page(program, help_topics(program), std::string(program_version())).c_str(), stdout);
    return Exit::Ok;
  }
  if (options.words.empty()) {
    std::fputs(help_index(program).c_str(), stdout);
    return Exit::Ok;
  }
  if (const auto* command = find_command(program, options.words)) {
    std::fputs(help_text(*command).c_str(), stdout);
    return Exit::Ok;
  }
  std::vector<std::string> names;
  for (const auto& command : program.commands) names.push_back(last_word(command.name));
  for (const auto& topic : help_topics(program)) {
    names.push_back(topic.name);
    if (options.words.size() == 1 && topic.name == options.words.front()) {
      std::fputs(topic.text.c_str(), stdout);
      return Exit::Ok;
    }
  }
  return refuse(unknown_name_error("topic", join(options.words, " "), names));
}

Exit complete(const std::string& shell, const CommandParser& app) {
  const CommandPage program = app.page();
  std::vector<std::string> topics;
  for (const auto& topic : help_topics(program)) topics.push_back(topic.name);
  const auto script = shell == "bash"  ? bash_completion(program, topics)
                      : shell == "zsh" ? zsh_completion(program, topics)
                                       : fish_completion(program, topics);
  std::fputs(script.c_str(), stdout);
  return Exit::Ok;
}

}  // namespace

void add_help_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<HelpOptions>();  // shared: the callback outlives this function
  auto* command = app.add_subcommand("help", "Explain a command or a topic");
  command->explain("", {{"unietp help", "all commands and topics"},
                        {"unietp help generate", ""},
                        {"unietp help scene import", ""},
                        {"unietp help modes", ""}});
  command->add_option("TOPIC", options->words, "A command or a topic; `unietp help` lists them");
  command->add_flag("--man", options->man, "Print the manual page of the whole program (roff)");
  command->callback([options, &app, &program] { program.exit = help(*options, app); });
}

void add_completion_command(CommandParser& app, CommandLine& program) {
  auto shell = std::make_shared<std::string>();  // shared: the callback outlives this function
  auto* command = app.add_subcommand("completion", "Print a completion script for bash, zsh or fish");
  command->explain("An installed program has them already.",
                   {{"source <(unietp completion bash)", "for the current shell"},
                    {"unietp completion zsh > ~/.zfunc/_unietp", ""},
                    {"unietp completion fish > ~/.config/fish/completions/unietp.fish", ""}});
  command->add_option("SHELL", *shell, "The shell")->required()->one_of({"bash", "zsh", "fish"});
  command->callback([shell, &app, &program] { program.exit = complete(*shell, app); });
}

}  // namespace unietp
