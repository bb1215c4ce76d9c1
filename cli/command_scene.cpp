#include "cli/command_scene.h"
#include "cli/command_parser.h"

namespace unietp {
void add_scene_command(CommandParser& app, CommandLine& program) {
  auto* group = app.add_subcommand("scene", "Make, import, export and inspect homes");
  group->explain(
      "Homes are files *.scene.json or *.scene.json.gz. `unietp generate --scenes FOLDER` makes tasks in them. "
      "See `unietp help homes`.",
      {{"unietp scene make --simulator habitat --count 5 --out out/homes", ""},
       {"unietp scene show out/homes/habitat-training-1-0.scene.json.gz --out home.svg", ""},
       {"unietp scene import auto FloorPlan1.json --out out/real", ""},
       {"unietp scene doctor FloorPlan1.json", "what is wrong with it"}});
  group->require_subcommand();
  add_scene_list_command(*group, program);
  add_scene_make_command(*group, program);
  add_scene_show_command(*group, program);
  add_scene_stats_command(*group, program);
  add_scene_import_command(*group, program);
  add_scene_doctor_command(*group, program);
  add_scene_report_command(*group, program);
  add_scene_export_command(*group, program);
  add_scene_fit_command(*group, program);
}

}  // namespace unietp
