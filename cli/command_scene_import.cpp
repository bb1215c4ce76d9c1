#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include <nlohmann/json.hpp>

#include "cli/command_parser.h"
#include "cli/command_scene.h"
#include "cli/common_options.h"
#include "cli/each_home.h"
#include "core/files.h"
#include "core/text.h"
#include "homes/foreign_scenes.h"
#include "homes/import_json.h"
#include "homes/scene_folder.h"
#include "interchange/formats.h"

namespace unietp {
namespace {

struct SceneImportOptions {
  std::string format, homes;
  std::vector<std::filesystem::path> files;
  std::filesystem::path out, assets;
  bool not_settled = false, own_ids = false, json = false;
  int threads = 1;
};

/// Result of one home.
struct ImportOutcome {
  std::optional<ImportReport> report;  // written
  std::optional<Error> failure;
};

void add(ImportReport& total, const ImportReport& report) {
  total.objects += report.objects;
  total.known += report.known;
  total.placed += report.placed;
  total.arrived += report.arrived;
  total.stayed += report.stayed;
  total.relations += report.relations;
  total.relations_held += report.relations_held;
  total.loose += report.loose;
  total.loose_held += report.loose_held;
}

std::string share(int part, int whole) {
  std::array<char, 16> text{};
  (void)std::snprintf(text.data(), text.size(), "%.1f %%", whole > 0 ? 100.0 * part / whole : 100.0);
  return text.data();
}

void print_row(const std::string& home, const std::string& format, const ImportReport& report) {
  std::printf("%-32s %-12s %8d %8d %8d %8s %10d %8d %8s\n", home.c_str(), format.c_str(), report.objects, report.known,
              report.arrived, share(report.arrived, report.known).c_str(), report.relations, report.relations_held,
              share(report.relations_held, report.relations).c_str());
}

void print_table(const std::vector<ForeignHome>& homes, const std::vector<ImportOutcome>& outcomes) {
  std::map<std::string, std::pair<int, ImportReport>> by_format;
  std::map<std::string, int> causes;
  std::printf("%-32s %-12s %8s %8s %8s %8s %10s %8s %8s\n", "home", "format", "objects", "known", "arrived", "",
              "relations", "held", "");
  for (std::size_t i = 0; i < homes.size(); ++i) {
    if (!outcomes[i].report) continue;
    const auto& report = *outcomes[i].report;
    const std::string format(name_of(homes[i].format));
    print_row(homes[i].source.id, format, report);
    auto& [count, total] = by_format[format];
    ++count;
    add(total, report);
    for (const auto& [reason, times] : causes_of(report)) causes[reason] += times;
  }
  for (const auto& [format, total] : by_format) print_row("all " + std::to_string(total.first), format, total.second);
  for (const auto& [reason, times] : causes) std::printf("%8d %s\n", times, reason.c_str());
}

void print_json(const SceneImportOptions& options, const std::vector<ForeignHome>& homes,
                const std::vector<ImportOutcome>& outcomes) {
  auto imported = nlohmann::ordered_json::array();
  auto failed = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < homes.size(); ++i) {
    const auto& home = homes[i];
    nlohmann::ordered_json one{
        {"id", home.source.id}, {"file", home.file.string()}, {"file_format", name_of(home.format)}};
    if (outcomes[i].report) {
      one["scene"] = scene_file_name(home.source.id);
      one["counts"] = counts_to_json(*outcomes[i].report);
      one["causes"] = causes_of(*outcomes[i].report);
      imported.push_back(std::move(one));
    } else if (outcomes[i].failure) {
      one["message"] = outcomes[i].failure->message;
      failed.push_back(std::move(one));
    }
  }
  const nlohmann::ordered_json json{{"format", "unietp-importing/1"},
                                    {"out", options.out.string()},
                                    {"homes", std::move(imported)},
                                    {"failed", std::move(failed)}};
  std::printf("%s\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace).c_str());
}

/// Keeps only the homes that were asked for. Errors: Usage for one that no file has.
Result<Done> choose(const std::string& asked, std::vector<ForeignHome>& homes) {
  std::set<std::string> wanted;
  for (const auto& id : split(asked, ',')) wanted.emplace(trim(id));
  std::vector<std::string> known;
  known.reserve(homes.size());
  for (const auto& home : homes) known.push_back(home.source.id);
  for (const auto& id : wanted) {
    if (std::find(known.begin(), known.end(), id) != known.end()) continue;
    const auto near = nearest_name(id, known);
    return Error{Error::Kind::Usage,
                 "--homes",
                 {},
                 "no file has a home \"" + id + "\"" + (near.empty() ? "" : ", did you mean \"" + near + "\"")};
  }
  std::erase_if(homes, [&](const ForeignHome& home) { return wanted.count(home.source.id) == 0; });
  return Done{};
}

/// The scene is written last, so that every scene has its report.
Result<Done> write_home(const SceneImportOptions& options, const ForeignHome& home, const ImportedScene& imported) {
  if (auto written = write_file(options.out, home.source.id + ".import.json", import_to_json(home, imported.report));
      !written)
    return written;
  return write_scene(options.out, imported.scene);
}

Exit import(const SceneImportOptions& options, const CommandLine& program) {
  const auto known = load_backends(program.folders);
  if (!known.errors.empty()) return refuse(known.errors);
  const auto formats = read_format_facts(program.folders.scene_files());
  if (!formats.errors.empty()) return refuse(formats.errors);
  auto reading = read_foreign_scenes(options.format, options.files, known.backends, formats.facts, options.assets);
  if (!reading.errors.empty()) return refuse(reading.errors);
  if (!options.homes.empty()) {
    if (const auto chosen = choose(options.homes, reading.homes); !chosen) return refuse(chosen.error());
  }
  const auto lock = prepare_folder(options.out);
  if (!lock) return refuse(lock.error());

  const auto& homes = reading.homes;
  std::vector<ImportOutcome> outcomes(homes.size());
  ImportOptions how;
  how.settle = !options.not_settled;
  how.own_ids = options.own_ids;
  std::atomic<bool> unwritable{false};
  const bool whole = for_each_home(homes.size(), options.threads, program, [&](std::size_t i) {
    const auto imported = import_home(homes[i], known.backends, formats.facts, how);
    if (!imported) {
      outcomes[i].failure = imported.error();
      return true;
    }
    if (const auto written = write_home(options, homes[i], *imported); !written) {
      outcomes[i].failure = written.error();
      unwritable = true;
      return false;
    }
    outcomes[i].report = imported->report;
    return true;
  });
  std::size_t failed = 0;
  for (std::size_t i = 0; i < homes.size(); ++i) {
    if (!outcomes[i].failure) continue;
    ++failed;
    (void)std::fprintf(stderr, "%s: %s\n", homes[i].file.c_str(), format(*outcomes[i].failure).c_str());
  }
  options.json ? print_json(options, homes, outcomes) : print_table(homes, outcomes);
  if (!whole) return Exit::Interrupted;
  if (unwritable || failed == homes.size()) return Exit::BadInput;
  return failed > 0 ? Exit::Wrong : Exit::Ok;
}

}  // namespace

void add_scene_import_command(CommandParser& group, CommandLine& program) {
  auto options = std::make_shared<SceneImportOptions>();  // shared: the callback outlives this function
  auto* command = group.add_subcommand("import", "Turn the simulators' own scene files into homes for tasks");
  command->explain(
      "A file may hold several homes: JSON lines, a list, or an object with homes by name. Each home becomes "
      "OUT/ID.scene.json.gz, and OUT/ID.import.json lists everything that could not be taken over, with the reason. "
      "Files of the same names are replaced.\n\n"
      "Exit code 1: some homes could not be converted; they are listed, and the others are written. Exit code 2: a "
      "file could not be read, or no home could be converted, and nothing is written.",
      {{"unietp scene import auto FloorPlan1.json TestScene1_graph.json.gz --out out/homes",
        "the format is detected for each file"},
       {"unietp scene import procthor houses.jsonl.gz --out out/houses", ""},
       {"unietp scene import ithor scenes.json --homes FloorPlan1,FloorPlan30 --out out/kitchens", "only these homes"},
       {"unietp scene import hssd flat.scene_instance.json --assets models.json --out out/hssd",
        "with a table of what its models are: {\"1efdc3d3\": {\"category\": \"bowl\", \"size\": [0.2, 0.2, 0.1], "
        "\"mass\": 0.3}}"},
       {"unietp scene import behavior house.json --assets object_inventory.json.gz --out out/behavior", ""}});
  auto formats = scene_format_names();
  formats.insert(formats.begin(), "auto");
  command->add_option("FORMAT", options->format, "Format of the files")->required()->suggests(formats);
  command->add_option("FILE", options->files, "Scene files (.json or .jsonl, also with .gz)")->required();
  command->add_option("--out", options->out, "Folder for scenes and reports")->required()->folder()->output();
  command->add_option("--homes", options->homes, "Ids of the homes to import (default: all)")->type_name("ID,...");
  command->add_option("--assets", options->assets,
                      "Categories and sizes of models that scenes only name: a table for Habitat, the object inventory "
                      "for BEHAVIOR");
  command->add_flag("--no-settle", options->not_settled, "Keep every position from the file; do not run physics");
  command->add_flag("--own-ids", options->own_ids,
                    "Objects keep the ids that the simulator has for them, for `unietp generate --native`");
  add_threads_option(*command, options->threads, program);
  command->add_flag("--json", options->json, "Print the report as JSON");
  command->callback([options, &program] { program.exit = import(*options, program); });
}

}  // namespace unietp
