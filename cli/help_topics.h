#pragma once

#include <string>
#include <vector>

#include "cli/command_page.h"

namespace unietp {

/// Something that `unietp help` explains and that is no command.
struct HelpTopic {
  std::string name;     // "modes"
  std::string summary;  // one line, no full stop
  std::string text;     // at most 80 columns
};

/// All topics in the order in which they are listed. `program`: the page of the whole program, for its global options.
std::vector<HelpTopic> help_topics(const CommandPage& program);

/// What `unietp --help` prints: at most 24 lines of at most 80 columns.
std::string main_screen();

/// What `unietp help` prints: all commands and topics.
std::string help_index(const CommandPage& program);

}  // namespace unietp
