#include "cli/library_options.h"
#include "cli/command_parser.h"

namespace unietp {

void add_library_options(CommandParser& command, CommandLine& program) {
  command
      .add_option("--templates", program.folders.templates,
                  "Folder (or file) of your own templates, which load beside the built-in ones; may be given again")
      ->type_name("DIR")
      ->one_each();  // one place each time it is given
  command.add_flag("--extended,--all", program.folders.extended_library,
                   "Take the extended library too (templates/extended)");
}

}  // namespace unietp
