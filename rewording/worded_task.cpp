#include "rewording/worded_task.h"

#include "dataset/configuration.h"
#include "record/dataset_reader.h"

namespace unietp {

Result<WordedTask> worded_task(const std::filesystem::path& folder, int line, TaskRecord record) {
  const auto file = (folder / kTasksFile).string();
  const auto at_line = [line](Error error) {
    error.pos = {line, error.pos.column};
    return error;
  };
  const auto split = split_named(record.split);
  const auto simulator = simulator_named(record.simulator);
  const auto style = style_named(record.style);
  const auto refinement = referring_named(record.refinement);
  if (!split || !simulator || !style || !refinement)
    return Error{Error::Kind::Schema, file, {line, 1}, "names an unknown split, simulator, style or refinement"};
  auto goal = parse_formula(file, record.goal_text, FormulaUse::Goal);
  if (!goal) return at_line(goal.error());
  WordedTask task;
  Specification& specification = task.specification;
  specification.template_name = record.template_name;
  specification.style = *style;
  specification.refinement = *refinement;
  specification.split = *split;
  specification.simulator = *simulator;
  specification.binding = record.bindings;
  specification.goal = std::move(*goal);
  for (const std::string& text : record.start_constraints) {
    auto formula = parse_formula(file, text, FormulaUse::State);
    if (!formula) return at_line(formula.error());
    specification.init.push_back(std::move(*formula));
  }
  task.record = std::move(record);
  return task;
}

English recorded_english(std::string_view name) { return name == name_of(English::Gb) ? English::Gb : English::Us; }

DatasetParts all_lines(const std::filesystem::path& folder) {
  std::error_code code;
  DatasetParts parts{.modes = shown_modes(folder), .wordings = std::filesystem::exists(folder / kWordingsFile, code)};
  if (parts.modes.empty()) parts.modes.push_back(Mode::M1);  // which every data set has
  return parts;
}

Result<Done> for_each_worded_task(const std::filesystem::path& folder, const DatasetParts& parts,
                                  const std::function<Result<Done>(WordedTask&&)>& use) {
  auto reader = DatasetReader::open(folder, parts);
  if (!reader) return reader.error();
  int line = 0;
  return for_each_task<WordedTask>(
      std::move(*reader), 1, [&](const FinishedTask& task) { return worded_task(folder, ++line, task.record); }, use);
}

Result<Done> for_each_matched_task(const std::filesystem::path& folder,
                                   const std::function<Result<Done>(WordedTask&&)>& use) {
  auto reader = DatasetReader::open(folder, all_lines(folder));
  if (!reader) return reader.error();
  for (int line = 1; const auto lines = reader->lines().next(); ++line) {
    if (const auto error = reader->line_error(*lines)) return *error;
    auto record = reader->task(*lines);
    if (!record) return record.error();
    auto task = worded_task(folder, line, std::move(*record));
    if (!task) return task.error();
    if (auto used = use(std::move(*task)); !used) return used;
  }
  if (const auto stray = reader->lines().next_stray()) return stray->error;
  return Done{};
}

Instruction instruction_of(const WordedTask& task) {
  const TaskRecord& record = task.record;
  std::vector<Style> phenomena;
  for (const std::string& name : record.phenomena)
    if (const auto style = style_named(name)) phenomena.push_back(*style);
  return {record.instruction, record.writer,        task.specification.style, record.checks,
          record.fallback,    std::move(phenomena), record.phrasing};
}

Result<Scene> read_start(HomeCache& homes, const WordedTask& task) {
  const TaskRecord& record = task.record;
  return homes.start("tasks.jsonl, " + record.id, record.layout, record.changes, record.scene);
}

}  // namespace unietp
