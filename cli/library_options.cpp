#include "cli/library_options.h"
#include "cli/command_parser.h"

namespace unietp {

void add_library_options(CommandParser& command, CommandLine& program) {
  command
      .add_option("--templates", program.folders.templates,
                  "Folder or file of your own templates, loaded beside the built-in ones; may be repeated")
      ->folder()
      ->one_each();  // so that the next argument is not taken for another folder
  command.add_flag("--extended,--all", program.folders.extended_library, "Also use the extended library");
}

}  // namespace unietp
