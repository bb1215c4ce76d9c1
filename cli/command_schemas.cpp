#include <cstdio>
#include <memory>

#include "cli/command_parser.h"
#include "cli/commands.h"
#include "exports/field_page.h"
#include "scene/schema_names.h"

namespace unietp {
namespace {

Exit show_schemas(bool page, bool names, const DataFolders& folders) {
  if (names) {
    std::fputs(schema_names().c_str(), stdout);
    return Exit::Ok;
  }
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
  auto page = std::make_shared<bool>(false);  // shared: the callback outlives this function
  auto names = std::make_shared<bool>(false);
  auto* command = app.add_subcommand("schemas", "Print where the JSON Schemas of all file formats are");
  command->explain("Every file that this program reads or writes for others has a JSON Schema.",
                   {{"unietp schemas", "the folder of the schemas"},
                    {"unietp schemas --page", "every field with its type and meaning, as Markdown (docs/fields.md)"},
                    {"unietp schemas --names", "names.schema.json: the names of actions, states and relations"}});
  command->add_flag("--page", *page, "Print all fields as Markdown");
  command->add_flag("--names", *names, "Print names.schema.json");
  command->callback([page, names, &program] { program.exit = show_schemas(*page, *names, program.folders); });
}

}  // namespace unietp
