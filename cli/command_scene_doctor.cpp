#include <cstdio>
#include <memory>
#include <optional>

#include <nlohmann/json.hpp>

#include "cli/command_parser.h"
#include "cli/command_scene.h"
#include "cli/common_options.h"
#include "cli/each_home.h"
#include "homes/home_doctor.h"

namespace unietp {
namespace {

struct SceneDoctorOptions {
  std::vector<std::filesystem::path> files;
  std::filesystem::path assets;
  int threads = 1, examples = 5;
  bool json = false;
};

/// Result of one home.
struct DoctorOutcome {
  std::optional<HomeDiagnosis> diagnosis;
  std::optional<Error> failure;
};

void print_json(const std::vector<HomeInFile>& homes, const std::vector<DoctorOutcome>& outcomes) {
  auto seen = nlohmann::ordered_json::array();
  auto failed = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < homes.size(); ++i) {
    if (outcomes[i].diagnosis) {
      seen.push_back(diagnosis_to_json(*outcomes[i].diagnosis));
    } else if (outcomes[i].failure) {
      failed.push_back(
          {{"id", homes[i].id}, {"file", homes[i].file.string()}, {"message", outcomes[i].failure->message}});
    }
  }
  const nlohmann::ordered_json json{
      {"format", "unietp-scene-doctor/1"}, {"homes", std::move(seen)}, {"failed", std::move(failed)}};
  std::printf("%s\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace).c_str());
}

Exit examine(const SceneDoctorOptions& options, const CommandLine& program) {
  const auto known = load_backends(program.folders);
  if (!known.errors.empty()) return refuse(known.errors);
  const auto formats = read_format_facts(program.folders.scene_files());
  if (!formats.errors.empty()) return refuse(formats.errors);
  const FormatFacts& facts = formats.facts;
  const auto reading = read_homes(options.files, known.backends, facts, options.assets);
  if (!reading.errors.empty()) return refuse(reading.errors);

  const auto& homes = reading.homes;
  std::vector<DoctorOutcome> outcomes(homes.size());
  const bool whole = for_each_home(homes.size(), options.threads, program, [&](std::size_t i) {
    auto diagnosis = diagnose(homes[i], known.backends, facts);
    if (diagnosis) {
      outcomes[i].diagnosis = std::move(*diagnosis);
    } else {
      outcomes[i].failure = diagnosis.error();
    }
    return true;
  });
  bool sound = true;
  for (std::size_t i = 0; i < homes.size(); ++i) {
    const auto& [diagnosis, failure] = outcomes[i];
    if (failure) (void)std::fprintf(stderr, "%s: %s\n", homes[i].file.c_str(), format(*failure).c_str());
    if (diagnosis && !options.json)
      std::fputs(diagnosis_text(*diagnosis, static_cast<std::size_t>(options.examples)).c_str(), stdout);
    sound = sound && diagnosis && diagnosis->faults.empty();
  }
  if (options.json) print_json(homes, outcomes);
  if (!whole) return Exit::Interrupted;
  return sound ? Exit::Ok : Exit::Wrong;
}

}  // namespace

void add_scene_doctor_command(CommandParser& group, CommandLine& program) {
  auto options = std::make_shared<SceneDoctorOptions>();  // shared: the callback outlives this function
  auto* command = group.add_subcommand("doctor", "Say what is wrong with a home, and what was done about it");
  command->explain(
      "A simulator's own file is imported as by `scene import`: what could not be taken over is listed with the "
      "reason, "
      "and each repair with its distance. Then the repaired home is checked: overlaps, what is sunk, floats or "
      "does "
      "not stay, what is fixed or lies outside, doors that are blocked, and rooms and furniture that the agent does "
      "not "
      "reach. Nothing is written.\n\n"
      "Exit code 0: nothing is wrong with the homes as they are now. Exit code 1: something is, or a home could not be "
      "converted. Exit code 2: a file could not be read.",
      {{"unietp scene doctor FloorPlan1.json", ""},
       {"unietp scene doctor out/homes --json", "scene files of ours, as a report for scripts"},
       {"unietp scene doctor house.json --assets object_inventory.json.gz --examples 100", ""}});
  command
      ->add_option("FILE", options->files,
                   "Scene files, ours or a simulator's (.json or .jsonl, also with .gz), or folders of ours")
      ->required();
  command->add_option("--assets", options->assets,
                      "Categories and sizes of models that scenes only name: a table for Habitat, the object inventory "
                      "for BEHAVIOR");
  command->add_option("--examples", options->examples, "Objects to name of each kind; JSON has all")
      ->within(0, 1'000'000)
      ->shows_default();
  add_threads_option(*command, options->threads, program);
  command->add_flag("--json", options->json, "Print the report as JSON");
  command->callback([options, &program] { program.exit = examine(*options, program); });
}

}  // namespace unietp
