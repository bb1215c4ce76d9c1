#pragma once

#include <string>
#include <vector>

#include "cli/command_page.h"
#include "cli/help_topics.h"

namespace unietp {

/// The program's manual page, unietp(1), as roff source: every command with its options and examples, and the topics.
std::string man_page(const CommandPage& program, const std::vector<HelpTopic>& topics, const std::string& version);

}  // namespace unietp
