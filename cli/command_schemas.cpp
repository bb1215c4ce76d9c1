#include <cstdio>
#include <memory>

#include "cli/command_parser.h"
#include "cli/commands.h"
#include "exports/field_page.h"

namespace unietp {
namespace {

constexpr const char* kHelp =
    "The fields of all files that this program reads and writes for others.\n"
    "\n"
    "  unietp schemas           the folder of the JSON Schemas\n"
    "  unietp schemas --page    docs/fields.md: every field with its type and meaning";

Exit show_schemas(bool page, const DataFolders& folders) {
  const auto schemas = folders.root / "data" / "schemas";
  if (!page) {
    std::printf("%s\n", schemas.string().c_str());
    return Exit::Ok;
  }
  const auto text = field_page(schemas);
  if (!text) return refuse(text.error());
  std::fputs(text->c_str(), stdout);
  return Exit::Ok;
}

}  // namespace

void add_schemas_command(CommandParser& app, CommandLine& program) {
  auto page = std::make_shared<bool>(false);  // shared: the callback below outlives this function
  auto* command = app.add_subcommand("schemas", kHelp);
  command->add_flag("--page", *page, "Print docs/fields.md");
  command->callback([page, &program] { program.exit = show_schemas(*page, program.folders); });
}

}  // namespace unietp
