#include "cli/command_template.h"
#include "cli/command_parser.h"

namespace unietp {
void add_template_command(CommandParser& app, CommandLine& program) {
  auto* group = app.add_subcommand("template", "Inspect, write, check and try task templates");
  group->explain(
      "A template is a text file that describes one kind of task. docs/add-a-template.md walks through "
      "writing one.",
      {{"unietp template list", ""},
       {"unietp template show place-one-on", ""},
       {"unietp template new my-task --like place-one-on", ""},
       {"unietp template try my-task.template", ""}});
  group->require_subcommand();
  add_template_list_command(*group, program);
  add_template_show_command(*group, program);
  add_template_vocabulary_command(*group, program);
  add_template_new_command(*group, program);
  add_template_lint_command(*group, program);
  add_template_try_command(*group, program);
  add_template_why_not_command(*group, program);
  add_template_coverage_command(*group, program);
}

}  // namespace unietp
