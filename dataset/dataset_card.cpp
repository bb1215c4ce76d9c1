#include "dataset/dataset_card.h"

#include <array>
#include <set>

#include "core/text.h"

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

std::string funnel_table(const DatasetCounts& counts) {
  std::string text = "| stage | reason | candidates |\n|---|---|---|\n";
  for (const auto& [stage, reasons] : counts.rejections) {
    for (const auto& [reason, count] : reasons)
      text += "| " + stage + " | " + reason + " | " + std::to_string(count) + " |\n";
  }
  return text + "| – | accepted | " + std::to_string(counts.tasks) + " |\n\n";
}

}  // namespace

std::string dataset_card(const RunConfiguration& configuration, const DatasetCounts& counts,
                         const std::vector<SourceLicence>& sources) {
  std::string text = metadata(configuration, counts.tasks);
  text += "# " + std::to_string(counts.tasks) + " verified embodied-planning tasks\n\n";
  text +=
      "Each task has a start scene at rest in a physics engine, a formal goal that is false there, an instruction "
      "that\nreads back to that goal, and a demonstration in each of " +
      modes_text(configuration) +
      " whose replay makes the goal true.\n\n"
      "```python\ndatasets.load_dataset(FOLDER, \"tasks\")   # or \"demonstrations-M1\"; M3 is read line by line, "
      "since "
      "its actions name rooms by\n                                        # texts and objects by boxes\n```\n\n";
  text += "## How it was made\n\nBy `unietp " + std::string(program_version()) + "` with seed " +
          std::to_string(configuration.seed) +
          "; the same program, tables and options give the same bytes (`manifest.json` has all of them).\nTemplates, "
          "knowledge of the simulators' objects, placement in physics, a scripted expert, and words that are checked "
          "against\nthe goal; what became of each candidate stands below. No language model wrote goals or "
          "demonstrations.\n\n";
  text +=
      "## How it is proven\n\nBefore a task is accepted its demonstration is executed in physics, the goal is "
      "evaluated on the trace by a second\nevaluator, leaving out any step of the demonstration must leave the goal "
      "unmet, and the instruction is read back into\nthe goal. `unietp validate FOLDER` does it again from these files "
      "alone: checksums, starts rebuilt at rest, every\nreplay with the same outcomes and views, goals false at the "
      "start and true at the end.\n\n";
  text += count_table("split", counts.by_split) + count_table("simulator", counts.by_simulator) +
          count_table("template", counts.by_template);
  text +=
      "## Files\n\n"
      "| file | content |\n|---|---|\n"
      "| `tasks.jsonl` | one task a line: template, bindings, goal as text and tree, start, instruction |\n"
      "| `homes/*.scene.json.gz` | the homes: rooms, objects, states, poses, relations; a task's `start.changes` makes "
      "its "
      "start |\n"
      "| `demonstrations/MODE.jsonl` | one demonstration a line, in the order of the tasks: what was seen, done, told "
      "and "
      "changed |\n"
      "| `rejections.jsonl` | each candidate that was given up, with stage and reason |\n"
      "| `dataset.sqlite` | tasks, bindings, steps, traits and rejections as tables |\n"
      "| `manifest.json` | version, configuration, counts and SHA-256 of each file |\n\n"
      "Lengths are metres, masses kilograms; rotations are unit quaternions [w, x, y, z], the angles of the agent "
      "radians; axes are right-handed, z up.\n\n";
  text += "## What became of the candidates\n\n" + funnel_table(counts);
  text += "## Sources of the facts\n\n";
  std::set<std::string> origins;
  for (const auto& source : sources) origins.insert("- " + source.origin + ": " + source.licence + "\n");
  for (const auto& origin : origins) text += origin;
  return text;
}

}  // namespace unietp
