#include "validator/database_check.h"

#include <algorithm>
#include <exception>

#include "core/sqlite_file.h"

namespace unietp {
namespace {

constexpr const char* kFile = "dataset.sqlite";

Problem wrong(const std::string& task, std::string message) {
  auto problem = problem_in(ProblemKind::Database, kFile, std::move(message));
  problem.task = task;
  return problem;
}

/// The first field in which a row differs from its task; "" when there is none.
std::string difference(Statement& row, const TaskRecord& task) {
  const std::vector<std::pair<std::string, const std::string*>> fields{
      {"id", &task.id},          {"template", &task.template_name},
      {"split", &task.split},    {"simulator", &task.simulator},
      {"scene", &task.scene},    {"layout", &task.layout},
      {"goal", &task.goal_text}, {"instruction", &task.instruction},
      {"style", &task.style},    {"writer", &task.writer}};
  int column = 0;
  for (const auto& [name, value] : fields) {
    if (row.text(column++) != *value) return name;
  }
  if (task.expert.empty()) return "";
  if (row.integer(column) != task.expert.front().steps) return "steps";
  return row.integer(column + 1) == task.expert.front().failures ? "" : "failures";
}

std::int64_t count(SqliteFile& file, const char* sql) {
  auto query = file.prepare(sql);
  return query.step() ? query.integer(0) : 0;
}

void compare_count(const char* table, std::int64_t there, std::int64_t wanted, std::vector<Problem>& problems) {
  if (there != wanted)
    problems.push_back(
        wrong("", "has " + std::to_string(there) + " rows in " + table + ", expected " + std::to_string(wanted)));
}

using Traits = std::map<std::string, std::vector<std::pair<std::string, std::string>>, std::less<>>;  // by task

Traits traits_in(SqliteFile& file) {
  Traits traits;
  auto rows = file.prepare("SELECT task, dimension, value FROM trait ORDER BY rowid");
  while (rows.step()) {
    const std::string task(rows.text(0));
    traits[task].emplace_back(rows.text(1), rows.text(2));
  }
  return traits;
}

/// Whether a task can count as this: by its own line and its start.
bool is_of(const TaskRecord& task, const TaskFacts& facts, const std::string& dimension, const std::string& value) {
  if (dimension == "template") return value == task.template_name;
  if (dimension == "scene") return value == task.layout;
  if (dimension == "room" && facts.rooms.contains(value)) return true;
  return (dimension == "room" || dimension == "category" || dimension == "receptacle") &&
         std::any_of(task.bindings.begin(), task.bindings.end(),
                     [&](const auto& bound) { return value == task.simulator + "/" + bound.second; });
}

void check_traits(const TaskReading& task, const TaskFacts& facts,
                  const std::vector<std::pair<std::string, std::string>>& traits, std::vector<Problem>& problems) {
  std::set<std::string> rooms = facts.rooms;
  int own = 0;  // template and home
  for (const auto& [dimension, value] : traits) {
    if (!is_of(*task.record, facts, dimension, value))
      problems.push_back(wrong(task.name, "lists " + dimension + " " + value + " for this task, which is wrong"));
    own += dimension == "template" || dimension == "scene" ? 1 : 0;
    if (dimension == "room") rooms.erase(value);
  }
  if (own != 2) problems.push_back(wrong(task.name, "does not list the template and home of this task"));
  for (const auto& room : rooms)
    problems.push_back(
        wrong(task.name, "does not list the room " + room + " for this task, which handles an object there"));
}

}  // namespace

DatabaseCheck check_database(const FolderReading& set, const std::vector<TaskFacts>& facts) {
  DatabaseCheck check;
  auto& problems = check.problems;
  try {
    SqliteFile file(set.folder / kFile, SqliteFile::Mode::Read);
    auto rows = file.prepare(
        "SELECT id, template, split, simulator, scene, layout, goal, instruction, style, writer, steps, failures FROM "
        "task ORDER BY rowid");
    auto traits = traits_in(file);
    std::size_t next = 0;
    for (; rows.step(); ++next) {
      if (next >= set.tasks.size()) continue;
      const TaskReading& task = set.tasks[next];
      if (const auto field = difference(rows, *task.record); !field.empty())
        problems.push_back(wrong(task.name, "has a different " + field + " for this task than tasks.jsonl"));
    }
    compare_count("task", static_cast<std::int64_t>(next), static_cast<std::int64_t>(set.tasks.size()), problems);
    std::int64_t bindings = 0, steps = 0;
    for (std::size_t i = 0; i < set.tasks.size(); ++i) {
      const TaskReading& task = set.tasks[i];
      bindings += static_cast<std::int64_t>(task.record->bindings.size());
      for (const auto& shown : task.record->expert) steps += shown.steps;
      const auto& own = traits[task.name];
      if (!facts[i].start_key.empty()) check_traits(task, facts[i], own, problems);
      for (const auto& [dimension, value] : own) ++check.traits[dimension][value];
    }
    compare_count("binding", count(file, "SELECT count(*) FROM binding"), bindings, problems);
    compare_count("step", count(file, "SELECT count(*) FROM step"), steps, problems);
    const auto rejections = LineFile::read(set.folder, "rejections.jsonl");
    compare_count("rejection", count(file, "SELECT count(*) FROM rejection"),
                  rejections ? static_cast<std::int64_t>(rejections->size()) : 0, problems);
  } catch (const std::exception& reason) {
    problems.push_back(wrong("", std::string("cannot be read: ") + reason.what()));
  }
  return check;
}

}  // namespace unietp
