#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iostream>
#include <limits>
#include <memory>

#include "cli/command_parser.h"
#include "cli/commands.h"
#include "core/files.h"
#include "core/limits.h"
#include "core/png.h"
#include "grounding/scene_svg.h"
#include "record/dataset_reader.h"
#include "simulation/channel_png.h"
#include "simulation/navigation.h"
#include "simulation/solids.h"
#include "simulation/view.h"
#include "simulation/viewpoint.h"

namespace unietp {
namespace {

struct RenderOptions {
  std::filesystem::path dataset, out;
  std::string task, mode = "M1", size, camera = "agent", channel = "color";
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

/// "64 to 1024".
std::string sides() {
  return std::to_string(limits::kLeastRenderedSide) + " to " + std::to_string(limits::kRenderedSide);
}

/// Sets the size of the picture. Errors: Usage unless it is WIDTHxHEIGHT with both in range.
Result<Done> resize(Profile& profile, const std::string& size) {
  const char* end = size.data() + size.size();
  int width = 0, height = 0;
  const auto [sign, bad] = std::from_chars(size.data(), end, width);
  const bool has_height = bad == std::errc() && sign != end && *sign == 'x';
  const auto [rest, bad_too] = std::from_chars(has_height ? sign + 1 : end, end, height);
  const auto fits = [](int side) { return side >= limits::kLeastRenderedSide && side <= limits::kRenderedSide; };
  if (!has_height || bad_too != std::errc() || rest != end || !fits(width) || !fits(height))
    return Error{Error::Kind::Usage, "--size", {}, "expected WIDTHxHEIGHT, each " + sides() + " pixels, as in 500x500"};
  profile.image_width = width;
  profile.image_height = height;
  return Done{};
}

/// A picture as PNG, with a box around each object that the agent is told about if `boxes`.
Result<std::string> seen(const Scene& scene, const Profile& profile, Viewpoint viewpoint, bool boxes) {
  Rays rays;
  Picture picture = picture_from(scene, profile, viewpoint, rays);
  constexpr std::array<std::uint8_t, 3> kFrame{255, 60, 20};
  if (boxes) {
    for (const VisibleObject& object : Viewer(scene).view(viewed(scene), scene.agent, profile, profile.sight_m))
      draw_box(picture, object.box, kFrame);
  }
  return png(picture.width, picture.height, picture.rgb);
}

/// Prints the number, the pixels and the id of each object in it.
void list_objects(const Channels& channels, const Scene& scene) {
  std::vector<int> pixels(scene.nodes.size() + 1);
  for (const std::int32_t node : channels.node) {
    if (node >= 0) ++pixels[static_cast<std::size_t>(node)];
  }
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (pixels[i] == 0) continue;
    std::cout << i + 1 << ',' << pixels[i] << ',' << (i < scene.nodes.size() ? scene.nodes[i].id : "agent") << '\n';
  }
}

std::vector<std::string> channel_names() {
  std::vector<std::string> names;
  for (const Channel channel : kChannels) names.emplace_back(name_of(channel));
  return names;
}

Result<std::string> measured(const Scene& scene, const Profile& profile, Viewpoint viewpoint, Channel channel) {
  Rays rays;
  const Channels channels = channels_from(scene, profile, viewpoint, rays);
  if (channel == Channel::Instances) list_objects(channels, scene);
  return channel_png(channels, channel);
}

/// What the options ask for, as the bytes of a PNG. Errors: Usage.
Result<std::string> picture(const Scene& scene, Profile profile, const RenderOptions& options) {
  if (!options.size.empty()) {
    if (const auto fine = resize(profile, options.size); !fine) return fine.error();
  }
  const auto viewpoint = *viewpoint_named(options.camera);
  if (const Channel channel = *channel_named(options.channel); channel != Channel::Color)
    return measured(scene, profile, viewpoint, channel);
  return seen(scene, profile, viewpoint, options.boxes);
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
  const bool own = viewpoint_named(options.camera) == Viewpoint::Agent;
  if (options.boxes && (!own || channel_named(options.channel) != Channel::Color))
    return refuse({Error::Kind::Usage, "--boxes", {}, "expected the agent's camera and color, which the boxes are of"});
  if (!as_seen && (!options.size.empty() || !own || channel_named(options.channel) != Channel::Color))
    return refuse({Error::Kind::Usage,
                   options.out.string(),
                   {},
                   "expected a file that ends in .png with --size, --camera and --channel"});
  const auto drawn = as_seen ? picture(scenes[options.step - 1], *profile, options)
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
      "agent's camera sees before one step of it. `unietp scene show` draws a home without a task.\n\n"
      "--camera behind follows the agent, --camera above shows the whole home; both show the agent. With --channel a "
      "PNG holds numbers instead of colors: depth in millimeters along the view direction (16 bits; 0: none, or over "
      "65 m); normals as red, green and blue of -1 to 1 to the right, down and ahead; instances as the number of the "
      "object (16 bits; 0: walls, floor and ceiling), whose number, pixels and id are printed.",
      {{"unietp render out/first ai2thor-00001 --out task.svg", ""},
       {"unietp render out/first ai2thor-00001 --out view.png --step 3 --boxes", ""},
       {"unietp render out/first ai2thor-00001 --out view.png --step 3 --mode M3", ""},
       {"unietp render out/first ai2thor-00001 --out above.png --camera above --size 800x600", ""},
       {"unietp render out/first ai2thor-00001 --out depth.png --channel depth", ""}});
  command->add_option("FOLDER", options->dataset, "A finished data set")->required()->folder();
  command->add_option("TASK", options->task, "Id of a task in it")->required();
  command->add_option("--out", options->out, "File to write; .png for the agent's view, otherwise SVG")
      ->required()
      ->output();
  command->add_option("--step", options->step, "PNG: the step to show the view before; one past the last shows the end")
      ->shows_default();
  command->add_option("--mode", options->mode, "Mode of the demonstration")
      ->one_of({"M1", "M2", "M3"})
      ->shows_default();
  command->add_flag("--boxes", options->boxes, "PNG: draw the boxes of the objects that the agent is told about");
  command->add_option("--size", options->size, "PNG: pixels, each side " + sides() + "; otherwise the simulator's")
      ->type_name("WIDTHxHEIGHT");
  command->add_option("--camera", options->camera, "PNG: the agent's own, one behind it, or one above the home")
      ->one_of({"agent", "behind", "above"})
      ->shows_default();
  command->add_option("--channel", options->channel, "PNG: what each pixel holds")
      ->one_of(channel_names())
      ->shows_default();
  command->callback([options, &program] { program.exit = render(*options, program.folders); });
}

}  // namespace unietp
