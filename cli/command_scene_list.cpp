#include <algorithm>
#include <cstdio>
#include <memory>

#include <nlohmann/json.hpp>

#include "cli/command_parser.h"
#include "cli/command_scene.h"
#include "cli/common_options.h"
#include "dataset/configuration.h"
#include "grounding/layout_library.h"

namespace unietp {
namespace {

struct SceneListOptions {
  std::string simulators;
  bool json = false;
};

Exit list(const SceneListOptions& options, const CommandLine& program) {
  std::vector<Simulator> wanted(kSimulators.begin(), kSimulators.end());
  if (!options.simulators.empty()) {
    auto simulators = parse_simulators("--simulators", options.simulators);
    if (!simulators) return refuse(simulators.error());
    wanted = std::move(*simulators);
  }
  const auto layouts = benchmark_layouts(program.folders.layouts());
  if (!layouts) return refuse(layouts.error());
  auto json = nlohmann::ordered_json::array();
  if (!options.json) std::printf("%-28s %-12s %6s %8s %20s\n", "layout", "simulator", "rooms", "objects", "seed");
  for (const auto& layout : *layouts) {
    if (std::find(wanted.begin(), wanted.end(), layout.simulator) == wanted.end()) continue;
    const std::string simulator(name_of(layout.simulator));
    if (options.json) {
      json.push_back({{"id", layout.id},
                      {"simulator", simulator},
                      {"seed", layout.seed},
                      {"rooms", layout.rooms},
                      {"objects", layout.objects}});
    } else {
      std::printf("%-28s %-12s %6d %8d %20s\n", layout.id.c_str(), simulator.c_str(), layout.rooms, layout.objects,
                  std::to_string(layout.seed).c_str());
    }
  }
  if (options.json) std::printf("%s\n", json.dump(2).c_str());
  return Exit::Ok;
}

}  // namespace

void add_scene_list_command(CommandParser& group, CommandLine& program) {
  auto options = std::make_shared<SceneListOptions>();  // shared: the callback outlives this function
  auto* command = group.add_subcommand("list", "List the homes of the benchmark");
  command->explain("`unietp scene make --layout ID` makes one of them.",
                   {{"unietp scene list", ""}, {"unietp scene list --simulators habitat,behavior --json", ""}});
  add_simulators_option(*command, options->simulators, "Only homes of these simulators (default: all)");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options, &program] { program.exit = list(*options, program); });
}

}  // namespace unietp
