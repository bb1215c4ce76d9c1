#pragma once

#include <string>

#include "cli/command_page.h"

namespace unietp {

/// Lines of at most `width` columns, each indented by `indent`; the first one without it when `hanging`. Breaks at
/// spaces; paragraphs (separated by empty lines) stay apart, and lines that begin with two spaces are kept as they are.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t width = 80, bool hanging = false);

/// "unietp validate FOLDER [OPTIONS]"
std::string usage_line(const CommandPage& page);

/// What `--help` prints for a command: usage, explanation, options, subcommands, examples; at most 80 columns except
/// for examples.
std::string help_text(const CommandPage& page);

}  // namespace unietp
