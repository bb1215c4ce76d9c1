#include <array>
#include <memory>

#include "cli/command_parser.h"
#include "cli/commands.h"
#include "core/files.h"
#include "core/png.h"
#include "grounding/scene_svg.h"
#include "record/dataset_reader.h"
#include "simulation/navigation.h"
#include "simulation/picture.h"
#include "simulation/solids.h"
#include "simulation/view.h"

namespace unietp {
namespace {

constexpr const char* kHelp =
    "Draw a task of a data set: from above as SVG, its start and the way that its demonstration goes; or as PNG\n"
    "what the agent sees before a step of it.\n"
    "\n"
    "  unietp render out/first ai2thor-00001 --out task.svg\n"
    "  unietp render out/first ai2thor-00001 --out seen.png --step 3 --boxes\n"
    "  unietp render out/first ai2thor-00001 --out seen.png --step 3 --mode M3\n"
    "\n"
    "`unietp scene show` draws a home without a task.";

struct Options {
  std::filesystem::path dataset, out;
  std::string task, mode = "M1";
  std::size_t step = 1;
  bool boxes = false;
};

using Legs = std::vector<std::vector<Vec2>>;

/// A task with its start and its demonstration in a mode. The lines in front of it are not parsed, only held to be
/// those of other tasks.
Result<FinishedTask> find_task(const std::filesystem::path& dataset, const std::string& task, Mode mode) {
  auto reader = DatasetReader::open(dataset, {.modes = {mode}, .starts = true});
  if (!reader) return reader.error();
  while (const auto lines = reader->lines().next()) {
    if (auto error = reader->line_error(*lines)) return *error;
    if (!lines->id.empty() && lines->id != task) continue;
    auto found = reader->read(*lines);
    if (!found || found->record.id == task) return found;
  }
  return Error{Error::Kind::Usage,
               (dataset / kTasksFile).string(),
               {},
               "has no task \"" + task + "\"; each line has its id first"};
}

/// The start of a task, then the scene after each step of its demonstration.
std::vector<Scene> scenes_of(const Scene& start, const DemonstrationRecord& shown) {
  std::vector<Scene> scenes{start};
  for (const StepRecord& step : shown.steps) scenes.push_back(apply(scenes.back(), step.changes));
  return scenes;
}

/// How the agent walks, one leg for each time that it changes its place.
Legs way_through(const std::vector<Scene>& scenes, const Profile& profile) {
  Legs legs;
  for (std::size_t i = 1; i < scenes.size(); ++i) {
    const Vec2 from = scenes[i - 1].agent.position, to = scenes[i].agent.position;
    if (from == to) continue;
    auto leg = NavigationGrid(scenes[i - 1], profile).walk(from, to);
    if (leg.empty()) leg = {from, to};
    legs.push_back(std::move(leg));
  }
  return legs;
}

/// What the agent sees, as PNG; with a frame around each object that it is told of.
Result<std::string> seen(const Scene& scene, const Profile& profile, bool boxes) {
  Rays rays;
  Picture picture = picture_of(scene, profile, rays);
  constexpr std::array<std::uint8_t, 3> kFrame{255, 60, 20};
  if (boxes) {
    for (const VisibleObject& object : Viewer(scene).view(viewed(scene), scene.agent, profile, profile.sight_m))
      draw_box(picture, object.box, kFrame);
  }
  return png(picture.width, picture.height, picture.rgb);
}

Exit render(const Options& options, const DataFolders& folders) {
  if (std::error_code code; !std::filesystem::is_directory(options.dataset, code))
    return refuse({Error::Kind::Usage,
                   options.dataset.string(),
                   {},
                   "is no folder; a data set is expected, and `unietp scene show` draws scene files"});
  const Mode mode = *mode_named(options.mode);
  const auto task = find_task(options.dataset, options.task, mode);
  if (!task) return refuse(task.error());
  const auto profile = load_profile(folders.profiles(), task->start.simulator);
  if (!profile) return refuse(profile.error());
  const auto scenes = scenes_of(task->start, task->shown.at(mode));
  const bool as_seen = options.out.extension() == ".png";
  if (options.step < 1 || options.step > scenes.size())
    return refuse({Error::Kind::Usage, "--step", {}, "expected 1 to " + std::to_string(scenes.size())});
  const auto drawn = as_seen ? seen(scenes[options.step - 1], *profile, options.boxes)
                             : Result<std::string>(scene_svg(task->start, way_through(scenes, *profile)));
  if (!drawn) return refuse(drawn.error());
  if (const auto written = write_file(options.out, *drawn); !written) return refuse(written.error());
  return Exit::Ok;
}

}  // namespace

void add_render_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<Options>();  // shared: the callback below outlives this function
  auto* command = app.add_subcommand("render", kHelp);
  command->add_option("dataset", options->dataset, "A finished data set")->required();
  command->add_option("task", options->task, "A task of the data set")->required();
  command->add_option("--out", options->out, "The file to write: .png for the agent's view, else SVG")->required();
  command->add_option("--step", options->step, "PNG: before which step of the demonstration; one more: after the last");
  command->add_option("--mode", options->mode, "Of which demonstration: M1, M2 or M3")->one_of({"M1", "M2", "M3"});
  command->add_flag("--boxes", options->boxes, "PNG: frame what the agent is told to see");
  command->callback([options, &program] { program.exit = render(*options, program.folders); });
}

}  // namespace unietp
