#pragma once

#include "pipeline/commands.h"

namespace unietp {

// The commands of `unietp scene`, one file each; added to the group as the others to the program.
void add_scene_fit_command(CLI::App& group, CommandLine& program);
void add_scene_export_command(CLI::App& group, CommandLine& program);
void add_scene_import_command(CLI::App& group, CommandLine& program);
void add_scene_list_command(CLI::App& group, CommandLine& program);
void add_scene_make_command(CLI::App& group, CommandLine& program);
void add_scene_show_command(CLI::App& group, CommandLine& program);
void add_scene_stats_command(CLI::App& group, CommandLine& program);

}  // namespace unietp
