#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <set>

#include <nlohmann/json.hpp>

#include "cli/command_parser.h"
#include "cli/command_scene.h"
#include "cli/each_home.h"
#include "core/files.h"
#include "core/text.h"
#include "dataset/configuration.h"
#include "grounding/home_census.h"
#include "grounding/scene_statistics.h"
#include "homes/home_files.h"

namespace unietp {
namespace {

constexpr const char* kHelp =
    "What homes hold on average, and how far two sets of them are apart.\n"
    "\n"
    "  unietp scene stats out/homes                       rooms, furniture, objects, free floor, what stands together\n"
    "  unietp scene stats houses.jsonl.gz --json > real.json\n"
    "      of a simulator's own files too; the JSON can be given back in place of homes\n"
    "  unietp scene stats out/homes real.json             how far apart: each part from 0 (the same) to 1\n"
    "  unietp scene stats out/homes --against reference   from the real homes that data/layouts/ was fitted to\n"
    "\n"
    "A set is a scene file, ours or a simulator's, a folder of scene files, or a file of statistics.";

struct Options {
  std::filesystem::path a, b;
  std::string simulator, against;
  int threads = 1;
  bool json = false;
};

Error usage(const std::filesystem::path& path, std::string message) {
  return {Error::Kind::Usage, path.string(), {}, std::move(message)};
}

/// The homes of one simulator only: categories of two cannot be counted together.
Result<std::vector<HomeInFile>> homes_of_one_simulator(const std::filesystem::path& path, const Options& options,
                                                       std::vector<HomeInFile> homes) {
  std::optional<Simulator> wanted;
  if (!options.simulator.empty()) {
    const auto simulators = parse_simulators("--simulator", options.simulator);
    if (!simulators) return simulators.error();
    if (simulators->size() != 1) return usage("--simulator", "expected one simulator");
    wanted = simulators->front();
  }
  std::set<Simulator> present;
  for (const auto& home : homes) present.insert(simulator_of(home));
  if (wanted) {
    std::erase_if(homes, [&](const HomeInFile& home) { return simulator_of(home) != *wanted; });
    if (homes.empty()) return usage(path, "holds no home of " + options.simulator);
  } else if (present.size() > 1) {
    std::vector<std::string> names;
    names.reserve(present.size());
    for (const auto simulator : present) names.emplace_back(name_of(simulator));
    return usage(path, "holds homes of " + join(names, ", ") + "; say which with --simulator");
  }
  return homes;
}

struct Measured {
  SceneStatistics statistics;
  std::optional<Simulator> simulator;  // a file of statistics does not say
};

/// nullopt when interrupted.
Result<std::optional<Measured>> measure(const std::filesystem::path& path, const Options& options,
                                        const std::vector<Backend>& backends, const CommandLine& program) {
  std::error_code code;
  if (!std::filesystem::is_directory(path, code)) {
    const auto text = read_maybe_gzip(path);
    if (!text) return text.error();
    if (text->find("\"unietp-scene-statistics/") != std::string::npos) {
      auto statistics = statistics_from_json(path.string(), *text);
      if (!statistics) return statistics.error();
      return std::optional(Measured{std::move(*statistics), std::nullopt});
    }
  }
  auto reading = read_homes({path}, backends);
  if (!reading.errors.empty()) return reading.errors.front();
  const auto homes = homes_of_one_simulator(path, options, std::move(reading.homes));
  if (!homes) return homes.error();
  std::vector<std::optional<Result<Scene>>> made(homes->size());
  const bool whole = for_each_home(homes->size(), options.threads, program, [&](std::size_t i) {
    made[i] = scene_of((*homes)[i], backends);
    return static_cast<bool>(*made[i]);
  });
  std::vector<Scene> scenes;
  for (std::size_t i = 0; i < made.size(); ++i) {
    if (made[i] && !*made[i]) return made[i]->error();
    if (made[i]) scenes.push_back(std::move(**made[i]));
  }
  if (!whole) return std::optional<Measured>();
  const auto structure = read_structure_names(program.folders.layouts() / "curated" / "structure.csv");
  if (!structure) return structure.error();
  return std::optional(
      Measured{statistics_of(scenes, *structure, path.filename().string()), simulator_of(homes->front())});
}

void print_distance(const SceneStatistics& a, const SceneStatistics& b, bool as_json) {
  const auto parts = parts_of(distance(a, b));
  if (as_json) {
    nlohmann::ordered_json distances;
    for (const auto& [name, value] : parts) distances[name] = value ? nlohmann::ordered_json(*value) : nullptr;
    const nlohmann::ordered_json json{
        {"format", "unietp-scene-distance/1"}, {"a", a.source}, {"b", b.source}, {"distance", std::move(distances)}};
    std::printf("%s\n", json.dump(2).c_str());
    return;
  }
  for (const auto* one : {&a, &b})
    std::printf("%s: %d homes, %.1f rooms and %.0f objects a home\n", one->source.c_str(), one->homes,
                one->rooms_per_home, one->objects_per_home);
  for (const auto& [name, value] : parts)
    std::printf("  %-28s %s\n", name.c_str(), value ? number_text(std::round(*value * 1000) / 1000).c_str() : "–");
}

/// The statistics of the real homes that data/layouts/ was fitted to.
Result<SceneStatistics> reference_of(std::optional<Simulator> simulator, const DataFolders& folders) {
  if (!simulator)
    return usage("--against", "expected homes, since a file of statistics does not say of which simulator");
  const std::string name(name_of(*simulator));
  const auto file = folders.layouts() / ("reference_" + name + ".json");
  if (std::error_code code; !std::filesystem::exists(file, code))
    return usage(file, "is not there: no real homes of " + name + " may be shipped; compare with another simulator's");
  const auto text = read_file(file);
  if (!text) return text.error();
  return statistics_from_json(file.string(), *text);
}

Exit stats(const Options& options, const CommandLine& program) {
  if (!options.against.empty() && (options.against != "reference" || !options.b.empty()))
    return refuse(usage("--against", "expected \"reference\" alone, or a second set of homes in its place"));
  const auto known = load_backends(program.folders);
  if (!known.errors.empty()) return refuse(known.errors);
  std::vector<SceneStatistics> sets;
  std::optional<Simulator> simulator;
  for (const auto& path : {options.a, options.b}) {
    if (path.empty()) continue;
    auto set = measure(path, options, known.backends, program);
    if (!set) return refuse(set.error());
    if (!*set) return Exit::Interrupted;
    sets.push_back(std::move((*set)->statistics));
    simulator = (*set)->simulator;
  }
  if (!options.against.empty()) {
    auto reference = reference_of(simulator, program.folders);
    if (!reference) return refuse(reference.error());
    sets.push_back(std::move(*reference));
  }
  if (sets.size() == 2) {
    print_distance(sets[0], sets[1], options.json);
  } else {
    std::printf("%s", (options.json ? statistics_to_json(sets[0]) : statistics_text(sets[0])).c_str());
  }
  return Exit::Ok;
}

}  // namespace

void add_scene_stats_command(CommandParser& group, CommandLine& program) {
  auto options = std::make_shared<Options>();  // shared: the callback below outlives this function
  options->threads = program.processors;
  auto* command = group.add_subcommand("stats", "What homes hold on average, and how far two sets are apart");
  command->footer(kHelp);
  command->add_option("a", options->a, "A set of homes")->required();
  command->add_option("b", options->b, "Another one, to compare with");
  command->add_option("--against", options->against, "reference: the real homes that the layout tables come from");
  command->add_option("--simulator", options->simulator,
                      "Of ai2thor,virtualhome,habitat,behavior, when a set has several");
  command->add_option("--threads", options->threads, "Threads (default: one a processor); never changes the result")
      ->within(1, 1024);
  command->add_flag("--json", options->json, "As JSON");
  command->callback([options, &program] { program.exit = stats(*options, program); });
}

}  // namespace unietp
