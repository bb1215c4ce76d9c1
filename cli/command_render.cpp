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

struct RenderOptions {
  std::filesystem::path dataset, out;
  std::string task, mode = "M1";
  std::size_t step = 1;
  bool boxes = false;
};

using Paths = std::vector<std::vector<Vec2>>;

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

/// The paths that the agent walks, one for each change of its position.
Paths paths_through(const std::vector<Scene>& scenes, const Profile& profile) {
  Paths paths;
  for (std::size_t i = 1; i < scenes.size(); ++i) {
    const Vec2 from = scenes[i - 1].agent.position, to = scenes[i].agent.position;
    if (from == to) continue;
    auto leg = NavigationGrid(scenes[i - 1], profile).walk(from, to);
    if (leg.empty()) leg = {from, to};
    paths.push_back(std::move(leg));
  }
  return paths;
}

/// The agent's view as PNG, with a box around each object that it is told about if `boxes`.
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

Exit render(const RenderOptions& options, const DataFolders& folders) {
  if (std::error_code code; !std::filesystem::is_directory(options.dataset, code))
    return refuse({Error::Kind::Usage,
                   options.dataset.string(),
                   {},
                   "is not a folder; expected a data set (`unietp scene show` draws scene files)"});
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
                             : Result<std::string>(scene_svg(task->start, paths_through(scenes, *profile)));
  if (!drawn) return refuse(drawn.error());
  if (const auto written = write_file(options.out, *drawn); !written) return refuse(written.error());
  return Exit::Ok;
}

}  // namespace

void add_render_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<RenderOptions>();  // shared: the callback outlives this function
  auto* command = app.add_subcommand("render", "Draw a task from above (SVG) or as the agent sees it (PNG)");
  command->explain(
      "An SVG shows the start scene from above with the path of the demonstration. A PNG shows what the "
      "agent's camera sees before one step of it. `unietp scene show` draws a home without a task.",
      {{"unietp render out/first ai2thor-00001 --out task.svg", ""},
       {"unietp render out/first ai2thor-00001 --out view.png --step 3 --boxes", ""},
       {"unietp render out/first ai2thor-00001 --out view.png --step 3 --mode M3", ""}});
  command->add_option("FOLDER", options->dataset, "A finished data set")->required()->folder();
  command->add_option("TASK", options->task, "Id of a task in it")->required();
  command->add_option("--out", options->out, "File to write; .png for the agent's view, otherwise SVG")->required();
  command->add_option("--step", options->step, "PNG: the step to show the view before; one past the last shows the end")
      ->shows_default();
  command->add_option("--mode", options->mode, "Mode of the demonstration")
      ->one_of({"M1", "M2", "M3"})
      ->shows_default();
  command->add_flag("--boxes", options->boxes, "PNG: draw the boxes of the objects that the agent is told about");
  command->callback([options, &program] { program.exit = render(*options, program.folders); });
}

}  // namespace unietp
