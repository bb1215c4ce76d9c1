#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "cli/command_parser.h"
#include "cli/command_scene.h"
#include "cli/common_options.h"
#include "cli/each_home.h"
#include "core/file_writer.h"
#include "core/files.h"
#include "homes/home_files.h"
#include "homes/home_plans.h"
#include "report/home_page.h"

namespace unietp {
namespace {

struct SceneReportOptions {
  std::vector<std::filesystem::path> files;
  std::filesystem::path out;
  int each = 6, views = 4, width = 400, threads = 1;
};

/// A home that is read or made when it is drawn.
using HomeSource = std::function<Result<Scene>()>;

/// So many homes of the benchmark for each simulator, spread over its list.
Result<std::vector<HomeSource>> benchmark_sources(const HomeInputs& inputs, const DataFolders& folders, int each) {
  const auto layouts = benchmark_layouts(folders.layouts());
  if (!layouts) return layouts.error();
  std::map<Simulator, std::vector<std::string>> ids;
  for (const auto& layout : *layouts) ids[layout.simulator].push_back(layout.id);
  std::vector<std::string> chosen;
  for (const auto& [simulator, all] : ids) {
    const auto wanted = std::min(static_cast<std::size_t>(each), all.size());
    for (std::size_t i = 0; i < wanted; ++i) chosen.push_back(all[i * all.size() / wanted]);
  }
  const auto plans = benchmark_homes(inputs, folders, false, chosen);
  if (!plans) return plans.error();
  std::vector<HomeSource> sources;
  for (const auto& plan : *plans) sources.push_back(plan.make);
  return sources;
}

Exit report(const SceneReportOptions& options, const CommandLine& program) {
  if (const auto writable = check_writable(options.out); !writable) return refuse(writable.error());
  const auto known = load_home_inputs(program.folders);
  if (!known.errors.empty()) return refuse(known.errors);
  const auto& backends = known.inputs.backends;
  const auto formats = read_format_facts(program.folders.scene_files());
  if (!formats.errors.empty()) return refuse(formats.errors);
  const FormatFacts& facts = formats.facts;
  HomesReading reading;
  std::vector<HomeSource> sources;
  if (options.files.empty()) {
    auto made = benchmark_sources(known.inputs, program.folders, options.each);
    if (!made) return refuse(made.error());
    sources = std::move(*made);
  } else {
    reading = read_homes(options.files, backends, facts);
    if (!reading.errors.empty()) return refuse(reading.errors);
    for (const auto& home : reading.homes)
      sources.emplace_back([&, one = &home] { return scene_of(*one, backends, facts); });
  }

  std::vector<std::optional<Result<ShownHome>>> shown(sources.size());
  const bool whole = for_each_home(sources.size(), options.threads, program, [&](std::size_t i) {
    const auto scene = sources[i]();
    if (scene) {
      const auto& profile = backends[static_cast<std::size_t>(scene->simulator)].profile;
      shown[i] = shown_home(*scene, profile, static_cast<std::size_t>(options.views), options.width);
    } else {
      shown[i] = scene.error();
    }
    return true;
  });
  if (!whole) return Exit::Interrupted;
  std::vector<ShownHome> homes;
  for (auto& one : shown) {
    if (!*one) return refuse(one->error());
    homes.push_back(std::move(**one));
  }
  const std::string page = home_page(homes);
  if (const auto written = write_file(options.out, page); !written) return refuse(written.error());
  std::printf("%s: %zu homes, %.1f MB\n", options.out.string().c_str(), homes.size(),
              static_cast<double>(page.size()) / 1e6);
  return Exit::Ok;
}

}  // namespace

void add_scene_report_command(CommandParser& group, CommandLine& program) {
  auto options = std::make_shared<SceneReportOptions>();  // shared: the callback outlives this function
  auto* command = group.add_subcommand("report", "Write a web page with homes from above and from inside");
  command->explain(
      "The page is one file that needs only a browser. Without files it shows homes of the benchmark of each "
      "simulator. A simulator's own file is imported first, with every object where the file places it.",
      {{"unietp scene report --out homes.html", "six homes of each simulator"},
       {"unietp scene report out/homes --views 8 --out homes.html", "these homes, up to eight rooms of each"}});
  command->add_option("FILE", options->files,
                      "Scene files, ours or a simulator's (.json or .jsonl, also with .gz), or folders of ours");
  command->add_option("--out", options->out, "HTML file to write")->required()->output();
  command->add_option("--each", options->each, "Homes of the benchmark of each simulator, when no file is given")
      ->within(1, 1000)
      ->shows_default();
  command->add_option("--views", options->views, "Rooms of each home that are shown from inside")
      ->within(0, 200)
      ->shows_default();
  command->add_option("--width", options->width, "Width of the pictures in pixels")->within(64, 2000)->shows_default();
  add_threads_option(*command, options->threads, program);
  command->callback([options, &program] { program.exit = report(*options, program); });
}

}  // namespace unietp
