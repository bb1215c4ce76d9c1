#include "cli/completion.h"
#include "core/text.h"

namespace unietp {
namespace {

/// Within single quotes of zsh.
std::string zsh_quoted(const std::string& text) { return "'" + replace_all(text, "'", "'\\''") + "'"; }

/// A description within an argument of _arguments.
std::string zsh_described(std::string text) {
  for (const char* sign : {"\\", "[", "]", ":"}) text = replace_all(text, sign, std::string("\\") + sign);
  return text;
}

std::string zsh_action(const OptionPage& option) {
  if (!option.choices.empty()) {
    const auto values = join(option.choices, " ");
    return takes_commas(option) ? "_values -s , value " + values : "(" + values + ")";
  }
  switch (option.completes) {
    case OptionPage::Completes::File:
      return "_files";
    case OptionPage::Completes::Folder:
      return "_files -/";
    case OptionPage::Completes::Nothing:
      break;
  }
  return " ";
}

std::string zsh_function(const std::string& name) { return "_" + replace_all(replace_all(name, " ", "_"), "-", "_"); }

std::string options_of(const CompletedCommand& command) {
  std::string text;
  for (const auto& option : command.options) {
    for (const auto& name : option.names) {
      std::string spec = (option.many ? "*" : "") + name + "[" + zsh_described(option.help) + "]";
      if (!option.value.empty()) spec += ":" + zsh_described(option.value) + ":" + zsh_action(option);
      text += " \\\n    " + zsh_quoted(spec);
    }
  }
  return text;
}

/// A command with subcommands: completes their names, then hands over to theirs.
std::string group_function(const CompletedCommand& command) {
  std::string names, cases;
  for (const auto& below : command.page->commands) {
    const std::string word = below.name.substr(below.name.rfind(' ') + 1);
    names += "        " + zsh_quoted(word + ":" + replace_all(below.summary, ":", "\\:")) + "\n";
    cases += "        " + word + ") " + zsh_function(below.name) + " ;;\n";
  }
  return zsh_function(command.page->name) + "() {\n  local state line\n  typeset -A opt_args\n  _arguments -C" +
         options_of(command) +
         " \\\n    '1: :->command' \\\n    '*:: :->rest'\n  case $state in\n    command)\n      local -a commands=(\n" +
         names + "      )\n      _describe command commands ;;\n    rest)\n      case $line[1] in\n" + cases +
         "      esac ;;\n  esac\n}\n\n";
}

std::string leaf_function(const CompletedCommand& command) {
  std::string arguments;
  int place = 0;
  const bool is_help = !command.words.empty() && command.word == "help";
  for (const auto& option : command.page->options) {
    if (!option.argument) continue;
    const std::string at = option.many ? "*" : std::to_string(++place);
    const std::string action = is_help ? "(" + join(command.words, " ") + ")" : zsh_action(option);
    arguments += " \\\n    " + zsh_quoted(at + ":" + zsh_described(option.names.front()) + ":" + action);
  }
  return zsh_function(command.page->name) + "() {\n  _arguments" + options_of(command) + arguments + "\n}\n\n";
}

}  // namespace

std::string zsh_completion(const CommandPage& program, const std::vector<std::string>& topics) {
  std::string text = "#compdef unietp\n# Completion of unietp for zsh; written by `unietp completion zsh`.\n\n";
  for (const auto& command : completed_commands(program, topics))
    text += command.page->commands.empty() ? leaf_function(command) : group_function(command);
  return text + "if [ \"$funcstack[1]\" = \"_unietp\" ]; then\n  _unietp \"$@\"\nelse\n  compdef _unietp unietp\nfi\n";
}

}  // namespace unietp
