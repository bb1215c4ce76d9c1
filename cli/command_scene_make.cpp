#include <cstdio>
#include <memory>
#include <optional>

#include <nlohmann/json.hpp>

#include "cli/command_parser.h"
#include "cli/command_scene.h"
#include "cli/common_options.h"
#include "cli/each_home.h"
#include "core/text.h"
#include "dataset/configuration.h"
#include "homes/home_plans.h"
#include "homes/scene_folder.h"

namespace unietp {
namespace {

struct SceneMakeOptions {
  std::string simulator, layouts;
  NewHomeOptions wanted;
  bool benchmark = false;
  int threads = 1;
  std::filesystem::path out;
  bool json = false;
};

/// Result of one home.
struct MakeOutcome {
  std::size_t rooms = 0, objects = 0;
  bool written = false;
  std::optional<Error> failure;
};

Result<std::vector<HomePlan>> plans_of_homes(const SceneMakeOptions& options, const DataFolders& folders,
                                             const HomeInputs& inputs) {
  if (options.simulator.empty()) {
    std::vector<std::string> ids;
    for (const auto& id : split(options.layouts, ',')) {
      if (!trim(id).empty()) ids.emplace_back(trim(id));
    }
    return benchmark_homes(inputs, folders, options.benchmark, ids);
  }
  const auto simulators = parse_simulators("--simulator", options.simulator);
  if (!simulators) return simulators.error();
  std::vector<HomePlan> homes;
  for (const auto simulator : *simulators) {
    for (auto& home : new_homes(inputs, simulator, options.wanted)) homes.push_back(std::move(home));
  }
  return homes;
}

void print_json(const SceneMakeOptions& options, const std::vector<HomePlan>& homes,
                const std::vector<MakeOutcome>& outcomes) {
  auto scenes = nlohmann::ordered_json::array();
  auto failed = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < homes.size(); ++i) {
    const auto& id = homes[i].id;
    const auto& outcome = outcomes[i];
    if (outcome.written) {
      scenes.push_back(
          {{"id", id}, {"file", scene_file_name(id)}, {"rooms", outcome.rooms}, {"objects", outcome.objects}});
    } else if (outcome.failure) {
      failed.push_back({{"id", id}, {"message", outcome.failure->message}});
    }
  }
  const nlohmann::ordered_json json{{"format", "unietp-scene-making/1"},
                                    {"out", options.out.string()},
                                    {"scenes", std::move(scenes)},
                                    {"failed", std::move(failed)}};
  std::printf("%s\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace).c_str());
}

void print_table(const SceneMakeOptions& options, const std::vector<HomePlan>& homes,
                 const std::vector<MakeOutcome>& outcomes) {
  std::size_t written = 0;
  for (std::size_t i = 0; i < homes.size(); ++i) {
    if (!outcomes[i].written) continue;
    ++written;
    std::printf("%-32s %3zu rooms %5zu objects\n", homes[i].id.c_str(), outcomes[i].rooms, outcomes[i].objects);
  }
  std::printf("%zu of %zu homes in %s\n", written, homes.size(), options.out.string().c_str());
}

Exit make(const SceneMakeOptions& options, const CommandLine& program) {
  const bool from_benchmark = options.benchmark || !options.layouts.empty();
  if (from_benchmark == !options.simulator.empty())
    return refuse({Error::Kind::Usage,
                   "scene make",
                   {},
                   "expected one of --simulator (new homes), --layout or --benchmark (homes of the benchmark)"});
  const auto reading = load_home_inputs(program.folders);
  if (!reading.errors.empty()) return refuse(reading.errors);
  const auto homes = plans_of_homes(options, program.folders, reading.inputs);
  if (!homes) return refuse(homes.error());
  const auto lock = prepare_folder(options.out);
  if (!lock) return refuse(lock.error());

  std::vector<MakeOutcome> outcomes(homes->size());
  std::atomic<bool> unwritable{false};
  const bool whole = for_each_home(homes->size(), options.threads, program, [&](std::size_t i) {
    auto& outcome = outcomes[i];
    const auto scene = (*homes)[i].make();
    if (!scene) {
      outcome.failure = scene.error();
      return true;
    }
    outcome.rooms = scene->rooms.size();
    outcome.objects = scene->nodes.size();
    const auto written = write_scene(options.out, *scene);
    outcome.written = static_cast<bool>(written);
    if (written) return true;
    outcome.failure = written.error();
    unwritable = true;
    return false;
  });
  bool failed = false;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (!outcomes[i].failure) continue;
    failed = true;
    (void)std::fprintf(stderr, "%s: %s\n", (*homes)[i].id.c_str(), format(*outcomes[i].failure).c_str());
  }
  options.json ? print_json(options, *homes, outcomes) : print_table(options, *homes, outcomes);
  if (!whole) return Exit::Interrupted;
  if (unwritable) return Exit::BadInput;
  return failed ? Exit::Wrong : Exit::Ok;
}

}  // namespace

void add_scene_make_command(CommandParser& group, CommandLine& program) {
  auto options = std::make_shared<SceneMakeOptions>();  // shared: the callback outlives this function
  auto* command = group.add_subcommand("make", "Make homes as scene files");
  command->explain(
      "Writes OUT/ID.scene.json.gz for each home and replaces files of the same names. The same options "
      "give the same bytes for any number of threads. Exit code 1: some homes could not be made; they are "
      "listed, and the others are written.",
      {{"unietp scene make --simulator ai2thor --count 10 --seed 3 --out out/homes",
        "ten homes, as training data uses"},
       {"unietp scene make --simulator behavior --rooms 5 --objects 120 --out out/small",
        "with a given number of rooms and about as many objects, furniture included"},
       {"unietp scene make --layout habitat-benchmark-07 --out out/homes",
        "a home of the benchmark; `unietp scene list` names them"},
       {"unietp scene make --benchmark --out out/benchmark", "all homes of the benchmark"}});
  auto* simulator = add_simulators_option(*command, options->simulator, "Make new homes for these", "--simulator");
  command->add_option("--count", options->wanted.count, "New homes per simulator")
      ->within(1, 1000000)
      ->needs(simulator)
      ->shows_default();
  command->add_option("--seed", options->wanted.seed, "Seed of the new homes")->needs(simulator)->shows_default();
  command->add_option("--rooms", options->wanted.rooms, "Rooms of a new home")->within(4, 12)->needs(simulator);
  command->add_option("--objects", options->wanted.objects, "Objects of a new home (default: 30 per room)")
      ->within(50, 600)
      ->needs(simulator);
  command->add_option("--layout", options->layouts, "Homes of the benchmark by id")->type_name("ID,...");
  command->add_flag("--benchmark", options->benchmark, "All homes of the benchmark");
  add_threads_option(*command, options->threads, program);
  command->add_option("--out", options->out, "Folder for the files")->required()->folder()->output();
  command->add_flag("--json", options->json, "Print the report as JSON");
  command->callback([options, &program] { program.exit = make(*options, program); });
}

}  // namespace unietp
