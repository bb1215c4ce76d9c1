#include "rewording/task_lines.h"

#include "core/files.h"
#include "core/text.h"
#include "record/task_record.h"

namespace unietp {
namespace {

Result<TaskLine> task_line(const std::string& where, int number, const std::string& line) {
  auto record = read_task(where, number, line);
  if (!record) return record.error();
  const auto at_line = [&](Error error) {
    error.pos = {number, error.pos.column};
    return error;
  };
  const auto split = split_named(record->split);
  const auto simulator = simulator_named(record->simulator);
  const auto style = style_named(record->style);
  if (!split || !simulator || !style)
    return Error{Error::Kind::Schema, where, {number, 1}, "names an unknown split, simulator or style"};
  auto goal = parse_formula(where, record->goal_text, FormulaUse::Goal);
  if (!goal) return at_line(goal.error());
  TaskLine task;
  task.text = line;
  task.id = std::move(record->id);
  task.scene = std::move(record->scene);
  task.layout = std::move(record->layout);
  task.changes = std::move(record->changes);
  task.seed = record->run;
  task.slot = record->slot;
  task.attempt = record->attempt;
  Specification& specification = task.specification;
  specification.template_name = std::move(record->template_name);
  specification.style = *style;
  specification.refinement = std::move(record->refinement);
  specification.split = *split;
  specification.simulator = *simulator;
  specification.binding = std::move(record->bindings);
  specification.goal = std::move(*goal);
  for (const std::string& text : record->start_constraints) {
    auto formula = parse_formula(where, text, FormulaUse::State);
    if (!formula) return at_line(formula.error());
    specification.init.push_back(std::move(*formula));
  }
  return task;
}

}  // namespace

Result<std::vector<TaskLine>> read_task_lines(const std::filesystem::path& folder) {
  const auto file = folder / "tasks.jsonl";
  const auto text = read_file(file);
  if (!text) return text.error();
  std::vector<TaskLine> tasks;
  int number = 0;
  for (const auto& line : split(*text, '\n')) {
    ++number;
    if (line.empty()) continue;
    auto task = task_line(file.string(), number, line);
    if (!task) return task.error();
    tasks.push_back(std::move(*task));
  }
  return tasks;
}

Result<Scene> read_start(HomeShelf& homes, const TaskLine& task) {
  return homes.start("tasks.jsonl, " + task.id, task.layout, task.changes, task.scene);
}

}  // namespace unietp
