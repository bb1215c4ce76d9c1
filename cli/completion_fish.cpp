#include "cli/completion.h"
#include "core/text.h"

namespace unietp {
namespace {

constexpr const char* kFishStart = R"(# Completion of unietp for fish; written by `unietp completion fish`.
function __unietp_at --description 'Whether the words so far name this command'
    set -l command unietp
    for word in (commandline -opc)[2..-1]
        if contains -- "$command $word" $__unietp_commands
            set command "$command $word"
        end
    end
    test "$command" = "$argv"
end
complete -c unietp -f
)";

std::string fish_quoted(const std::string& text) {
  return "'" + replace_all(replace_all(text, "\\", "\\\\"), "'", "\\'") + "'";
}

std::string fish_paths(OptionPage::Completes completes) {
  switch (completes) {
    case OptionPage::Completes::File:
      return " -F";
    case OptionPage::Completes::Folder:
      return " -a '(__fish_complete_directories)'";
    case OptionPage::Completes::Nothing:
      break;
  }
  return "";
}

std::string option_line(const std::string& start, const OptionPage& option) {
  std::string line = start;
  for (const auto& name : option.names) line += " -l " + name.substr(2);
  if (!option.value.empty()) line += " -r";
  if (!option.choices.empty() && takes_commas(option)) {
    line += " -a " + fish_quoted("(__fish_append , " + join(option.choices, " ") + ")");
  } else if (!option.choices.empty()) {
    line += " -a " + fish_quoted(join(option.choices, " "));
  } else {
    line += fish_paths(option.completes);
  }
  return line + " -d " + fish_quoted(option.help) + "\n";
}

}  // namespace

std::string fish_completion(const CommandPage& program, const std::vector<std::string>& topics) {
  const auto commands = completed_commands(program, topics);
  std::string text = kFishStart, names;
  for (const auto& command : commands) {
    const std::string& name = command.page->name;
    if (&command != &commands.front()) names += " " + fish_quoted(name);
    const std::string start = "complete -c unietp -n " + fish_quoted("__unietp_at " + name);
    for (const auto& option : command.options) text += option_line(start, option);
    for (const auto& below : command.page->commands)
      text +=
          start + " -a " + below.name.substr(below.name.rfind(' ') + 1) + " -d " + fish_quoted(below.summary) + "\n";
    if (command.page->commands.empty() && !command.words.empty())
      text += start + " -a " + fish_quoted(join(command.words, " ")) + "\n";
    if (command.paths != OptionPage::Completes::Nothing) text += start + fish_paths(command.paths) + "\n";
  }
  return text + "set -g __unietp_commands" + names + "\n";
}

}  // namespace unietp
