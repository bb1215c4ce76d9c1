#include <cstdio>
#include <memory>

#include "cli/command_parser.h"
#include "cli/command_scene.h"
#include "core/files.h"
#include "core/text.h"
#include "grounding/scene_svg.h"
#include "homes/home_files.h"

namespace unietp {
namespace {

struct SceneShowOptions {
  std::filesystem::path input, out;
  std::string home;
};

/// The home to draw. Errors: Usage when it is not clear which.
Result<const HomeInFile*> chosen(const std::vector<HomeInFile>& homes, const SceneShowOptions& options) {
  std::vector<std::string> ids;
  for (const auto& home : homes) {
    if (home.id == options.home || (options.home.empty() && homes.size() == 1)) return &home;
    ids.push_back(home.id);
  }
  const auto near = nearest_name(options.home, ids);
  const std::size_t all = ids.size();
  constexpr std::size_t kShown = 10;
  if (all > kShown) ids.resize(kShown);
  const std::string has = "it has " + std::to_string(all) + ": " + join(ids, ", ") + (all > kShown ? ", ..." : "");
  if (options.home.empty())
    return Error{Error::Kind::Usage, options.input.string(), {}, "choose a home with --home; " + has};
  return Error{
      Error::Kind::Usage,
      options.input.string(),
      {},
      "has no home \"" + options.home + "\"" + (near.empty() ? "" : ", did you mean \"" + near + "\"") + "; " + has};
}

Exit show(const SceneShowOptions& options, const CommandLine& program) {
  const auto known = load_backends(program.folders);
  if (!known.errors.empty()) return refuse(known.errors);
  const auto [facts, wrong] = read_format_facts(program.folders.scene_files());
  if (!wrong.empty()) return refuse(wrong);
  const auto reading = read_homes({options.input}, known.backends, facts);
  if (!reading.errors.empty()) return refuse(reading.errors);
  const auto home = chosen(reading.homes, options);
  if (!home) return refuse(home.error());
  const auto scene = scene_of(**home, known.backends, facts);
  if (!scene) return refuse(scene.error());
  if (const auto written = write_file(options.out, scene_svg(*scene)); !written) return refuse(written.error());
  return Exit::Ok;
}

}  // namespace

void add_scene_show_command(CommandParser& group, CommandLine& program) {
  auto options = std::make_shared<SceneShowOptions>();  // shared: the callback outlives this function
  auto* command = group.add_subcommand("show", "Draw a home from above as SVG");
  command->explain(
      "Shows rooms, walls, doors, furniture, objects and the agent. A simulator's own file is imported "
      "first, with every object where the file places it. `unietp render` draws a task of a data set.",
      {{"unietp scene show home.scene.json.gz --out home.svg", ""},
       {"unietp scene show TestScene1_graph.json --out home.svg", ""},
       {"unietp scene show houses.jsonl.gz --home train_3 --out home.svg", "one home of several in a file"}});
  command->add_option("FILE", options->input, "A scene file, ours or a simulator's (.json or .jsonl, also with .gz)")
      ->required();
  command->add_option("--home", options->home, "Id of the home, when the file has several");
  command->add_option("--out", options->out, "SVG file to write")->required()->output();
  command->callback([options, &program] { program.exit = show(*options, program); });
}

}  // namespace unietp
