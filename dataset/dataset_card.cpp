#include "dataset/dataset_card.h"

#include <array>
#include <cstdio>
#include <set>

#include "core/text.h"
#include "scene/simulator_forms.h"

namespace unietp {
namespace {

std::string size_category(int tasks) {
  constexpr std::array<std::pair<int, const char*>, 6> kSizes{{{1000, "n<1K"},
                                                               {10000, "1K<n<10K"},
                                                               {100000, "10K<n<100K"},
                                                               {1000000, "100K<n<1M"},
                                                               {10000000, "1M<n<10M"},
                                                               {100000000, "10M<n<100M"}}};
  for (const auto& [below, name] : kSizes) {
    if (tasks < below) return name;
  }
  return "100M<n<1B";
}

/// A table for `datasets`. Types are read from the first part of a file, of which the reader takes 10 MB unless told
/// otherwise; a field that comes later would then be refused.
std::string table(const std::string& name, const std::string& file, const std::string& split) {
  return "- config_name: " + name + "\n  data_files:\n  - split: " + split + "\n    path: " + file +
         "\n  chunksize: 1073741824\n";
}

/// What Hugging Face reads. M3's actions name rooms by texts and objects by boxes, which no column holds.
std::string metadata(const RunConfiguration& configuration, int tasks) {
  const std::string split = configuration.homes == HomeSource::Benchmark ? "test" : "train";
  std::string text =
      "---\nlicense: mit\nlanguage:\n- en\ntask_categories:\n- robotics\ntags:\n- embodied-planning\n"
      "- task-planning\n- instruction-following\n- formal-goals\n- demonstrations\n- synthetic\n";
  for (const Simulator simulator : configuration.simulators) text += "- " + std::string(name_of(simulator)) + "\n";
  text += "pretty_name: Verified embodied-planning tasks\nsize_categories:\n- " + size_category(tasks) + "\nconfigs:\n";
  text += table("tasks", "tasks.jsonl", split) + "  default: true\n";
  for (const Mode mode : configuration.modes) {
    const std::string name(name_of(mode));
    if (mode != Mode::M3) text += table("demonstrations-" + name, "demonstrations/" + name + ".jsonl", split);
  }
  return text + "---\n\n";
}

std::string modes_text(const RunConfiguration& configuration) {
  std::vector<std::string> names;
  for (const Mode mode : configuration.modes) names.emplace_back(name_of(mode));
  return join(names, ", ");
}

std::string count_table(const std::string& title, const std::map<std::string, int>& counts) {
  std::string text = "| " + title + " | tasks |\n|---|---|\n";
  for (const auto& [name, count] : counts) text += "| " + name + " | " + std::to_string(count) + " |\n";
  return text + "\n";
}

int count_of(const std::map<std::string, int>& counts, std::string_view name) {
  const auto found = counts.find(std::string(name));
  return found == counts.end() ? 0 : found->second;
}

/// How many of a simulator's tasks each of its forms expresses; "" where no simulator has tasks.
std::string forms_table(const DatasetCounts& counts) {
  std::string rows;
  for (const SimulatorForm& form : kSimulatorForms) {
    const int all = count_of(counts.by_simulator, name_of(form.simulator));
    if (all == 0) continue;
    const int expressed = count_of(counts.by_form, form.name);
    std::array<char, 32> share{};
    (void)std::snprintf(share.data(), share.size(), "%.1f %%", 100.0 * expressed / all);
    rows += "| " + std::string(form.name) + " | " + std::to_string(expressed) + " | " + std::to_string(all) + " | " +
            share.data() + " |\n";
  }
  if (rows.empty()) return "";
  return "## In the simulators\n\nSome tasks can also be done in the simulator itself: `unietp export --format FORM` "
         "writes them, and the field `forms` of a\ntask names them.\n\n"
         "| form | tasks | of its simulator's | share |\n|---|---|---|---|\n" +
         rows + "\n";
}

std::string funnel_table(const DatasetCounts& counts) {
  std::string text = "| stage | reason | candidates |\n|---|---|---|\n";
  for (const auto& [stage, reasons] : counts.rejections) {
    for (const auto& [reason, count] : reasons)
      text += "| " + stage + " | " + reason + " | " + std::to_string(count) + " |\n";
  }
  return text + "| – | accepted | " + std::to_string(counts.tasks) + " |\n\n";
}

}  // namespace

std::string dataset_card(const Manifest& manifest) {
  const RunConfiguration& configuration = manifest.configuration;
  const DatasetCounts& counts = manifest.counts;
  std::string text = metadata(configuration, counts.tasks);
  text += "# " + std::to_string(counts.tasks) + " verified embodied-planning tasks\n\n";
  text +=
      "Each task consists of a furnished home, at rest in a physics engine; a formal goal that is false at the start; "
      "an English\ninstruction that states the goal; and demonstrations (" +
      modes_text(configuration) +
      ") that reach the goal.\n\n"
      "```python\ndatasets.load_dataset(FOLDER, \"tasks\")   # or \"demonstrations-M1\"; read M3 line by line: its "
      "actions name rooms\n                                        # by text and objects by boxes\n```\n\n";
  text +=
      "## How it was made\n\nGenerated by `unietp " + manifest.version + "` with seed " +
      std::to_string(configuration.seed) +
      ". The same program, tables and options, all recorded in `manifest.json`, give the same bytes.\nTemplates and "
      "knowledge about the simulators' objects give the goal, objects are placed with physics, a scripted expert\n"
      "solves the task, and the instruction is checked against the goal. No language model wrote goals or "
      "demonstrations.\n\n";
  text +=
      "## How it was verified\n\nEvery demonstration was executed in physics and its goal evaluated on the resulting "
      "trace. Without any one of its steps the\ngoal is not reached, but for those that are marked as search or "
      "tidying. Every instruction was read back and compared with its goal. "
      "`unietp validate FOLDER` repeats all of this from the\nfiles alone: checksums, starts at rest, replays with the "
      "same results and views, goals false at the start and true at the end.\n\n";
  text += count_table("split", counts.by_split) + count_table("simulator", counts.by_simulator) +
          count_table("template", counts.by_template) + forms_table(counts);
  text +=
      "## Files\n\n"
      "| file | content |\n|---|---|\n"
      "| `tasks.jsonl` | one task per line: template, bindings, goal as text and tree, start, instruction, forms |\n"
      "| `homes/*.scene.json.gz` | the homes: rooms, objects, states, poses, relations; a task's `start.changes` gives "
      "its "
      "start |\n"
      "| `demonstrations/MODE.jsonl` | one demonstration per line, in the order of the tasks: observations, actions, "
      "feedback "
      "and changes |\n"
      "| `rejections.jsonl` | each rejected candidate, with stage and reason |\n"
      "| `dataset.sqlite` | tasks, bindings, steps, traits and rejections as tables |\n"
      "| `manifest.json` | version, configuration, counts and SHA-256 of each file |\n\n"
      "Lengths are in meters, masses in kilograms, angles of the agent in radians; rotations are unit quaternions "
      "[w, x, y, z]; axes are right-handed with z up.\n\n";
  text += "## Results of the candidates\n\n" + funnel_table(counts);
  text += "## Sources of the facts\n\n";
  std::set<std::string> origins;
  for (const auto& source : manifest.sources) origins.insert("- " + source.origin + ": " + source.license + "\n");
  for (const auto& origin : origins) text += origin;
  return text;
}

}  // namespace unietp
