#pragma once

#include <string>
#include <vector>

namespace unietp {

/// One command line and what it does. Shown in help and in the manual page.
struct CommandExample {
  std::string line;
  std::string effect;  // "": the line speaks for itself
};

/// An option or an argument of a command, as help, the manual page and the shell completions show it.
struct OptionPage {
  enum class Completes { Nothing, File, Folder };

  std::vector<std::string> names;    // "--scenes", "--scene"; an argument has one name in capitals: "FOLDER"
  std::string value;                 // placeholder: "N", "FILE"; "" for a flag
  std::string help;                  // one sentence without a full stop
  std::vector<std::string> choices;  // values that completion offers
  std::string fallback;              // default value; "" when none is shown
  Completes completes = Completes::Nothing;
  bool argument = false, required = false;
  bool many = false;  // several values
};

/// A command with its options and subcommands: plain data from which help, manual page and completions are written.
struct CommandPage {
  std::string name;     // as typed: "unietp scene import"
  std::string summary;  // one line, no full stop
  std::string about;    // paragraphs, separated by empty lines
  std::vector<CommandExample> examples;
  std::vector<OptionPage> options;  // arguments among them; in the order of their definition
  std::vector<CommandPage> commands;
};

}  // namespace unietp
