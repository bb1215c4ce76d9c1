#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/text.h"
#include "grounding/scene_svg.h"
#include "pipeline/commands.h"
#include "scene/scene_json.h"
#include "simulation/navigation.h"

namespace unietp {
namespace {

constexpr const char* kHelp =
    "Draw a task of a data set from above as SVG: its start, with the way that its demonstration goes.\n"
    "\n"
    "  unietp render out/first ai2thor-00001 --out task.svg\n"
    "\n"
    "`unietp scene show` draws a home without a task.";

struct Options {
  std::filesystem::path dataset, out;
  std::string task;
};

using Legs = std::vector<std::vector<Vec2>>;

/// How the agent of a task's demonstration walks, one leg for each time that it changes its place.
Result<Legs> way_of(const std::filesystem::path& file, const std::string& task, const Scene& start,
                    const Profile& profile) {
  const auto text = read_file(file);
  if (!text) return text.error();
  for (const auto& line : split(*text, '\n')) {
    if (line.empty()) continue;
    const auto json = nlohmann::ordered_json::parse(line, nullptr, false);
    if (!json.is_object() || json.value("task", "") != task) continue;
    Legs legs;
    Scene scene = start;
    for (const auto& step : json.value("steps", nlohmann::ordered_json::array())) {
      const auto changes = delta_from_json(file.string(), step.value("changes", nlohmann::ordered_json::object()));
      if (!changes) return changes.error();
      const Scene before = scene;
      scene = apply(std::move(scene), *changes);
      if (scene.agent.position == before.agent.position) continue;
      auto leg = NavigationGrid(before, profile).walk(before.agent.position, scene.agent.position);
      if (leg.empty()) leg = {before.agent.position, scene.agent.position};
      legs.push_back(std::move(leg));
    }
    return legs;
  }
  return Error{Error::Kind::Usage, file.string(), {}, "has no task \"" + task + "\"; tasks.jsonl lists the ids"};
}

Exit render(const Options& options, const DataFolders& folders) {
  if (std::error_code code; !std::filesystem::is_directory(options.dataset, code))
    return refuse({Error::Kind::Usage,
                   options.dataset.string(),
                   {},
                   "is no folder; a data set is expected, and `unietp scene show` draws scene files"});
  const auto scene_file = options.dataset / "scenes" / (options.task + ".scene.json.gz");
  const auto text = read_maybe_gzip(scene_file);
  if (!text) return refuse(text.error());
  const auto scene = scene_from_json(scene_file.string(), *text);
  if (!scene) return refuse(scene.error());
  const auto profile = load_profile(folders.profiles(), scene->simulator);
  if (!profile) return refuse(profile.error());
  const auto way = way_of(options.dataset / "demonstrations" / "M1.jsonl", options.task, *scene, *profile);
  if (!way) return refuse(way.error());
  if (const auto written = write_file(options.out, scene_svg(*scene, *way)); !written) return refuse(written.error());
  return Exit::Ok;
}

}  // namespace

void add_render_command(CLI::App& app, CommandLine& program) {
  auto options = std::make_shared<Options>();  // shared: the callback below outlives this function
  auto* command = app.add_subcommand("render", kHelp);
  command->add_option("dataset", options->dataset, "A finished data set")->required();
  command->add_option("task", options->task, "A task of the data set")->required();
  command->add_option("--out", options->out, "The SVG file to write")->required();
  command->callback([options, &program] { program.exit = render(*options, program.folders); });
}

}  // namespace unietp
