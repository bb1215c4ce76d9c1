#pragma once

#include "cli/commands.h"

namespace unietp {

// The commands of `unietp scene`, one file each; added to the group as the others to the program.
void add_scene_doctor_command(CommandParser& group, CommandLine& program);
void add_scene_fit_command(CommandParser& group, CommandLine& program);
void add_scene_export_command(CommandParser& group, CommandLine& program);
void add_scene_import_command(CommandParser& group, CommandLine& program);
void add_scene_list_command(CommandParser& group, CommandLine& program);
void add_scene_make_command(CommandParser& group, CommandLine& program);
void add_scene_report_command(CommandParser& group, CommandLine& program);
void add_scene_show_command(CommandParser& group, CommandLine& program);
void add_scene_stats_command(CommandParser& group, CommandLine& program);

}  // namespace unietp
