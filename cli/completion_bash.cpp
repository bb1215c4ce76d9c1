#include "cli/completion.h"
#include "core/text.h"

namespace unietp {
namespace {

constexpr const char* kBashStart = R"(# Completion of unietp for bash; written by `unietp completion bash`.
_unietp() {
  local current="${COMP_WORDS[COMP_CWORD]}" previous="${COMP_WORDS[COMP_CWORD-1]}" command=unietp i
  COMPREPLY=()
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case "$command ${COMP_WORDS[i]}" in
)";

constexpr const char* kBashMiddle = R"() command+=" ${COMP_WORDS[i]}" ;;
    esac
  done

  # Values of the option before the cursor
  local values='' paths=''
  case "$command $previous" in
)";

constexpr const char* kBashValues = R"(  esac
  case "$paths" in
    file) compopt -o filenames; mapfile -t COMPREPLY < <(compgen -f -- "$current"); return ;;
    folder) compopt -o filenames; mapfile -t COMPREPLY < <(compgen -d -- "$current"); return ;;
    any) return ;;
    list)
      local before=''
      [[ $current == *,* ]] && before="${current%,*},"
      compopt -o nospace
      mapfile -t COMPREPLY < <(compgen -P "$before" -W "$values" -- "${current##*,}")
      return ;;
    values) mapfile -t COMPREPLY < <(compgen -W "$values" -- "$current"); return ;;
  esac

  # Options and arguments of the command
  local words='' options=''
  case "$command" in
)";

constexpr const char* kBashEnd = R"(  esac
  if [[ $current == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current")
    return
  fi
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
  case "$paths" in
    file) compopt -o filenames; mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -- "$current") ;;
    folder) compopt -o filenames; mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -d -- "$current") ;;
  esac
}
complete -F _unietp unietp
)";

std::string paths_word(OptionPage::Completes completes) {
  switch (completes) {
    case OptionPage::Completes::File:
      return "file";
    case OptionPage::Completes::Folder:
      return "folder";
    case OptionPage::Completes::Nothing:
      break;
  }
  return "";
}

std::string value_case(const std::string& command, const OptionPage& option) {
  std::vector<std::string> patterns;
  for (const auto& name : option.names) patterns.push_back("\"" + command + " " + name + "\"");
  std::string kind = paths_word(option.completes), values;
  if (!option.choices.empty()) {
    kind = takes_commas(option) ? "list" : "values";
    values = " values='" + join(option.choices, " ") + "'";
  }
  return "    " + join(patterns, "|") + ") paths=" + (kind.empty() ? "any" : kind) + values + " ;;\n";
}

}  // namespace

std::string bash_completion(const CommandPage& program, const std::vector<std::string>& topics) {
  const auto commands = completed_commands(program, topics);
  std::vector<std::string> names;
  std::string values, words;
  for (const auto& command : commands) {
    const std::string& name = command.page->name;
    if (&command != &commands.front()) names.push_back("\"" + name + "\"");
    std::vector<std::string> options;
    for (const auto& option : command.options) {
      options.insert(options.end(), option.names.begin(), option.names.end());
      if (!option.value.empty()) values += value_case(name, option);
    }
    words += "    \"" + name + "\") words='" + join(command.words, " ") + "' options='" + join(options, " ") + "'" +
             (command.paths == OptionPage::Completes::Nothing ? "" : " paths=" + paths_word(command.paths)) + " ;;\n";
  }
  return kBashStart + ("      " + join(names, "|\\\n      ")) + kBashMiddle + values + kBashValues + words + kBashEnd;
}

}  // namespace unietp
