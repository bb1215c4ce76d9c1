#include "pipeline/dataset_card.h"

#include <set>

namespace unietp {
namespace {

std::string size_category(int tasks) {
  if (tasks < 1000) return "n<1K";
  if (tasks < 10000) return "1K<n<10K";
  return tasks < 100000 ? "10K<n<100K" : "100K<n<1M";
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
  std::string text = "---\nlicense: mit\nlanguage:\n- en\ntask_categories:\n- robotics\ntags:\n- embodied-planning\n";
  text += "- task-planning\npretty_name: Verified embodied-planning tasks\nsize_categories:\n- " +
          size_category(counts.tasks) + "\nconfigs:\n";
  text += "- config_name: tasks\n  data_files: tasks.jsonl\n  default: true\n";
  text += "- config_name: demonstrations\n  data_files: demonstrations/*.jsonl\n---\n\n";
  text += "# " + std::to_string(counts.tasks) + " verified embodied-planning tasks\n\n";
  text +=
      "Each task has a start scene at rest in a physics engine, a formal goal that is false there, an instruction "
      "that\n"
      "reads back to that goal, and a demonstration whose replay makes the goal true. Leaving out any step of the\n"
      "demonstration leaves the goal unmet.\n\n";
  text +=
      "Made by `unietp " + std::string(program_version()) + "` with seed " + std::to_string(configuration.seed) +
      "; the same program, tables and options give the same bytes. `unietp validate FOLDER` proves every task again\n"
      "from these files alone.\n\n";
  text += count_table("split", counts.by_split) + count_table("simulator", counts.by_simulator) +
          count_table("template", counts.by_template);
  text +=
      "## Files\n\n"
      "| file | content |\n|---|---|\n"
      "| `tasks.jsonl` | one task a line: template, bindings, goal as text and tree, start, instruction |\n"
      "| `scenes/*.scene.json.gz` | the start scene of each task: rooms, objects, states, poses, relations |\n"
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
