#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <set>

#include <nlohmann/json.hpp>

#include "cli/command_parser.h"
#include "cli/command_scene.h"
#include "cli/common_options.h"
#include "cli/each_home.h"
#include "core/files.h"
#include "core/text.h"
#include "dataset/configuration.h"
#include "grounding/home_census.h"
#include "grounding/home_traits.h"
#include "grounding/scene_statistics.h"
#include "homes/home_files.h"

namespace unietp {
namespace {

struct SceneStatsOptions {
  std::filesystem::path a, b;
  std::string simulator, against;
  int threads = 1;
  bool json = false, traits = false;
};

Error set_error(const std::filesystem::path& path, std::string message) {
  return {Error::Kind::Usage, path.string(), {}, std::move(message)};
}

/// The homes of one simulator only: categories of two cannot be counted together.
Result<std::vector<HomeInFile>> homes_of_one_simulator(const std::filesystem::path& path,
                                                       const SceneStatsOptions& options,
                                                       std::vector<HomeInFile> homes) {
  std::optional<Simulator> wanted;
  if (!options.simulator.empty()) {
    const auto simulators = parse_simulators("--simulator", options.simulator);
    if (!simulators) return simulators.error();
    if (simulators->size() != 1) return set_error("--simulator", "expected one simulator");
    wanted = simulators->front();
  }
  std::set<Simulator> present;
  for (const auto& home : homes) present.insert(simulator_of(home));
  if (wanted) {
    std::erase_if(homes, [&](const HomeInFile& home) { return simulator_of(home) != *wanted; });
    if (homes.empty()) return set_error(path, "holds no home of " + options.simulator);
  } else if (present.size() > 1) {
    std::vector<std::string> names;
    names.reserve(present.size());
    for (const auto simulator : present) names.emplace_back(name_of(simulator));
    return set_error(path, "holds homes of " + join(names, ", ") + "; choose one with --simulator");
  }
  return homes;
}

struct HomeSet {
  std::vector<Scene> homes;
  Simulator simulator;
};

/// nullopt when interrupted.
Result<std::optional<HomeSet>> read_set(const std::filesystem::path& path, const SceneStatsOptions& options,
                                        const std::vector<Backend>& backends, const CommandLine& program) {
  const auto formats = read_format_facts(program.folders.scene_files());
  if (!formats.errors.empty()) return formats.errors.front();
  auto reading = read_homes({path}, backends, formats.facts);
  if (!reading.errors.empty()) return reading.errors.front();
  const auto homes = homes_of_one_simulator(path, options, std::move(reading.homes));
  if (!homes) return homes.error();
  std::vector<std::optional<Result<Scene>>> made(homes->size());
  const bool whole = for_each_home(homes->size(), options.threads, program, [&](std::size_t i) {
    made[i] = scene_of((*homes)[i], backends, formats.facts);
    return static_cast<bool>(*made[i]);
  });
  HomeSet set{{}, simulator_of(homes->front())};
  for (std::size_t i = 0; i < made.size(); ++i) {
    if (made[i] && !*made[i]) return made[i]->error();
    if (made[i]) set.homes.push_back(std::move(**made[i]));
  }
  if (!whole) return std::optional<HomeSet>();
  return std::optional(std::move(set));
}

Result<StructureNames> structure_names(const CommandLine& program) {
  return read_structure_names(program.folders.layouts() / "curated" / "structure.csv");
}

struct Measured {
  SceneStatistics statistics;
  std::optional<Simulator> simulator;  // a file of statistics does not say
};

/// nullopt when interrupted.
Result<std::optional<Measured>> measure(const std::filesystem::path& path, const SceneStatsOptions& options,
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
  const auto set = read_set(path, options, backends, program);
  if (!set) return set.error();
  if (!*set) return std::optional<Measured>();
  const auto structure = structure_names(program);
  if (!structure) return structure.error();
  return std::optional(Measured{statistics_of((*set)->homes, *structure, path.filename().string()), (*set)->simulator});
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
  if (!simulator) return set_error("--against", "needs homes; a file of statistics does not name its simulator");
  const std::string name(name_of(*simulator));
  const auto file = folders.layouts() / ("reference_" + name + ".json");
  if (std::error_code code; !std::filesystem::exists(file, code))
    return set_error(
        file, "does not exist: no real homes of " + name + " may be redistributed; compare with another simulator");
  const auto text = read_file(file);
  if (!text) return text.error();
  return statistics_from_json(file.string(), *text);
}

std::set<std::string> room_types_of(const std::vector<Scene>& homes) {
  std::set<std::string> types;
  for (const Scene& home : homes) {
    for (const Room& room : home.rooms) types.insert(room.type);
  }
  return types;
}

std::string decimals_or_none(const std::optional<double>& value, int decimals) {
  if (!value) return "-";
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, *value);
  return text.data();
}

void print_comparison(const HomeComparison& comparison, const std::set<std::string>& types, bool as_json) {
  if (as_json) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const TraitComparison& one : comparison.traits) {
      const auto or_null = [](const std::optional<double>& value) {
        return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
      };
      rows.push_back(
          {{"trait", one.trait}, {"unit", one.unit}, {"made", or_null(one.made)}, {"halves", or_null(one.halves)}});
    }
    const nlohmann::ordered_json json{{"format", "unietp-home-traits/1"}, {"room_types", types},
                                      {"made", comparison.made},          {"real", comparison.real},
                                      {"sample", comparison.sample},      {"traits", std::move(rows)}};
    std::printf("%s\n", json.dump(2).c_str());
    return;
  }
  std::printf("%d homes of A, %d of B of like size; %d in each sample. Rooms: %s\n", comparison.made, comparison.real,
              comparison.sample, join({types.begin(), types.end()}, ", ").c_str());
  std::printf("  %9s %12s %7s  %s\n", "A to B", "halves of B", "ratio", "trait");
  for (const TraitComparison& one : comparison.traits) {
    const auto ratio =
        one.made && one.halves && *one.halves > 0 ? std::optional(*one.made / *one.halves) : std::nullopt;
    std::printf("  %9s %12s %7s  %s%s\n", decimals_or_none(one.made, 4).c_str(),
                decimals_or_none(one.halves, 4).c_str(), decimals_or_none(ratio, 2).c_str(), one.trait.c_str(),
                one.unit.empty() ? "" : (" (" + one.unit + ")").c_str());
  }
}

Exit compare_traits(const SceneStatsOptions& options, const std::vector<Backend>& backends,
                    const CommandLine& program) {
  if (options.b.empty() || !options.against.empty())
    return refuse(set_error("--traits", "expected two sets of homes, A and B"));
  std::vector<HomeSet> sets;
  for (const auto& path : {options.a, options.b}) {
    auto set = read_set(path, options, backends, program);
    if (!set) return refuse(set.error());
    if (!*set) return Exit::Interrupted;
    sets.push_back(std::move(**set));
  }
  const auto structure = structure_names(program);
  if (!structure) return refuse(structure.error());
  std::set<std::string> types;
  const auto other = room_types_of(sets[1].homes);
  for (const std::string& type : room_types_of(sets[0].homes)) {
    if (other.contains(type)) types.insert(type);
  }
  std::vector<HomeTraits> traits[2];
  for (std::size_t i = 0; i < 2; ++i) {
    for (const Scene& home : sets[i].homes) traits[i].push_back(traits_of(home, *structure, types));
  }
  print_comparison(compare_homes(traits[0], traits[1]), types, options.json);
  return Exit::Ok;
}

Exit stats(const SceneStatsOptions& options, const CommandLine& program) {
  if (!options.against.empty() && (options.against != "reference" || !options.b.empty()))
    return refuse(set_error("--against", "expected \"reference\" and no second set of homes"));
  const auto known = load_backends(program.folders);
  if (!known.errors.empty()) return refuse(known.errors);
  if (options.traits) return compare_traits(options, known.backends, program);
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
  auto options = std::make_shared<SceneStatsOptions>();  // shared: the callback outlives this function
  auto* command = group.add_subcommand("stats", "Print averages over homes, or the distance between two sets of homes");
  command->explain(
      "A set is a scene file (ours or a simulator's), a folder of scene files, or a file of statistics that "
      "this command wrote. Each part of a distance is between 0 (equal) and 1.",
      {{"unietp scene stats out/homes", "rooms, furniture, objects, free floor, and what stands together"},
       {"unietp scene stats houses.jsonl.gz --json > real.json", ""},
       {"unietp scene stats out/homes real.json", "the distance between the two"},
       {"unietp scene stats out/homes real --traits", "16 traits, next to the distance between two halves of real"},
       {"unietp scene stats out/homes --against reference",
        "the distance from the real homes that data/layouts/ was fitted to"}});
  command->add_option("A", options->a, "A set of homes")->required();
  command->add_option("B", options->b, "A set to compare it with");
  command->add_option("--against", options->against, "Compare with the real homes behind the layout tables")
      ->type_name("reference")
      ->suggests({"reference"});
  add_simulators_option(*command, options->simulator, "Which homes to count, when a set has several simulators'",
                        "--simulator")
      ->type_name("NAME");
  command->add_flag("--traits", options->traits,
                    "Compare A with B trait by trait, and with what two halves of B differ by");
  add_threads_option(*command, options->threads, program);
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options, &program] { program.exit = stats(*options, program); });
}

}  // namespace unietp
