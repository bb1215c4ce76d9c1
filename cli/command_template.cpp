#include "cli/command_template.h"
#include "cli/command_parser.h"

namespace unietp {
namespace {

constexpr const char* kHelp =
    "The task templates, and what it takes to add one; docs/add-a-template.md goes through all of it.\n"
    "\n"
    "  unietp template list                      what the library has\n"
    "  unietp template show place-one-on         one of them in words, and what may fill it\n"
    "  unietp template vocabulary                every word that a template may use\n"
    "  unietp template new my-task               write a new one\n"
    "  unietp template lint my-task.template     check files or folders before they join the library\n"
    "  unietp template try my.template           tasks that it makes in a few homes, or what stops them\n"
    "  unietp template why-not place-one-inside --bind A=Fridge B=Mug    which gate refuses it, and why\n"
    "  unietp template coverage --tries 10       what comes of each template on each simulator that it claims\n"
    "\n"
    "`unietp template COMMAND --help` explains each.";

}  // namespace

void add_template_command(CommandParser& app, CommandLine& program) {
  auto* group = app.add_subcommand("template", kHelp);
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
