#include "cli/command_scene.h"
#include "cli/command_parser.h"

namespace unietp {
namespace {

constexpr const char* kHelp =
    "Homes: those of the benchmark, new ones, and the simulators' own.\n"
    "\n"
    "  unietp scene list                                             the homes of the benchmark\n"
    "  unietp scene make --benchmark --out out/homes                 all of them as scene files\n"
    "  unietp scene make --simulator habitat --count 5 --out out/new new homes\n"
    "  unietp scene show out/homes/ai2thor-benchmark-01.scene.json.gz --out home.svg\n"
    "  unietp scene stats out/homes                                  what the homes of a folder hold\n"
    "  unietp scene fit ../shared/upstream                           the tables of homes from real ones\n"
    "  unietp scene import auto FloorPlan1.json --out out/real       a simulator's own homes\n"
    "  unietp scene export procthor home.scene.json.gz --out house.json   the other way\n"
    "\n"
    "`unietp scene COMMAND --help` explains each. `unietp generate --scenes FOLDER` makes tasks in such homes.";

}  // namespace

void add_scene_command(CommandParser& app, CommandLine& program) {
  auto* group = app.add_subcommand("scene", kHelp);
  group->require_subcommand();
  add_scene_fit_command(*group, program);
  add_scene_export_command(*group, program);
  add_scene_import_command(*group, program);
  add_scene_list_command(*group, program);
  add_scene_make_command(*group, program);
  add_scene_show_command(*group, program);
  add_scene_stats_command(*group, program);
}

}  // namespace unietp
