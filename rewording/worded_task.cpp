#include "rewording/worded_task.h"

#include "record/dataset_reader.h"

namespace unietp {
namespace {

Result<WordedTask> worded_task(const std::string& file, int line, TaskRecord record) {
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

}  // namespace

Result<std::vector<WordedTask>> read_worded_tasks(const std::filesystem::path& folder) {
  std::error_code code;
  const bool wordings = std::filesystem::exists(folder / kWordingsFile, code);
  auto modes = shown_modes(folder);
  if (modes.empty()) modes.push_back(Mode::M1);  // which every data set has
  auto reader = DatasetReader::open(folder, {.modes = std::move(modes), .wordings = wordings});
  if (!reader) return reader.error();
  const auto file = (folder / kTasksFile).string();
  std::vector<WordedTask> tasks;
  const auto done = for_each_task<TaskRecord>(
      std::move(*reader), 1, [](const FinishedTask& task) -> Result<TaskRecord> { return task.record; },
      [&](TaskRecord&& record) -> Result<Done> {
        auto task = worded_task(file, static_cast<int>(tasks.size()) + 1, std::move(record));
        if (!task) return task.error();
        tasks.push_back(std::move(*task));
        return Done{};
      });
  if (!done) return done.error();
  return tasks;
}

Instruction instruction_of(const WordedTask& task) {
  const TaskRecord& record = task.record;
  return {record.instruction, record.writer, task.specification.style, record.checks, record.fallback};
}

Result<Scene> read_start(HomeCache& homes, const WordedTask& task) {
  const TaskRecord& record = task.record;
  return homes.start("tasks.jsonl, " + record.id, record.layout, record.changes, record.scene);
}

}  // namespace unietp
