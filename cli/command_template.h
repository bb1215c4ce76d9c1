#pragma once

#include "cli/commands.h"

namespace unietp {

// Each adds one subcommand of `unietp template`.
void add_template_coverage_command(CommandParser& group, CommandLine& program);
void add_template_lint_command(CommandParser& group, CommandLine& program);
void add_template_list_command(CommandParser& group, CommandLine& program);
void add_template_new_command(CommandParser& group, CommandLine& program);
void add_template_show_command(CommandParser& group, CommandLine& program);
void add_template_try_command(CommandParser& group, CommandLine& program);
void add_template_vocabulary_command(CommandParser& group, CommandLine& program);
void add_template_why_not_command(CommandParser& group, CommandLine& program);

}  // namespace unietp
