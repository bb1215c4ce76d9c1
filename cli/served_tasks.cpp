#include "cli/served_tasks.h"

#include <memory>
#include <utility>

#include "cli/command_parser.h"
#include "cli/common_options.h"
#include "dataset/configuration.h"
#include "procedural/procedural.h"
#include "procedural/simulator_data.h"
#include "record/manifest_record.h"

namespace unietp {
namespace {

Result<Procedural> new_tasks(const TaskChoice& choice, const std::shared_ptr<const Resources>& resources) {
  ProceduralOptions options;
  if (!choice.simulators.empty()) {
    auto simulators = parse_simulators("--simulators", choice.simulators);
    if (!simulators) return simulators.error();
    options.simulators = std::move(*simulators);
  }
  if (!choice.splits.empty()) {
    auto splits = parse_splits("--splits", choice.splits);
    if (!splits) return splits.error();
    options.splits = std::move(*splits);
  }
  return Procedural::make(resources, options);
}

}  // namespace

void add_procedural_options(CommandParser& command, TaskChoice& choice) {
  auto* procedural = command.add_flag("--procedural", choice.procedural, "Make new tasks, one for each seed");
  add_simulators_option(command, choice.simulators, "Simulators of new tasks (default: all)")->needs(procedural);
  command.add_option("--splits", choice.splits, "Splits of new tasks (default: all)")
      ->type_name("NAME,...")
      ->suggests(split_names())
      ->needs(procedural);
}

TasksReading served_tasks(const TaskChoice& choice, const CommandLine& program) {
  TasksReading reading;
  auto folders = program.folders;
  folders.extended_library = !choice.folder.empty() && records_extended_library(choice.folder);
  auto loaded = load_resources(folders);
  reading.errors = std::move(loaded.errors);
  if (!reading.errors.empty()) return reading;
  const auto resources = std::make_shared<const Resources>(std::move(loaded.resources));
  if (!choice.folder.empty()) {
    auto source = TaskSource::open(choice.folder, simulator_data(resources), choice.kept);
    if (!source) reading.errors.push_back(source.error());
    if (source) reading.tasks.stored = std::move(*source);
  }
  if (choice.procedural) {
    auto made = new_tasks(choice, resources);
    if (!made) reading.errors.push_back(made.error());
    if (made) reading.tasks.made = [made = std::move(*made)](std::uint64_t seed) { return made.task(seed); };
  }
  return reading;
}

}  // namespace unietp
