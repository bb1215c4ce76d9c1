#include "validator/database_check.h"

#include <algorithm>
#include <exception>

#include "core/file_place.h"
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

struct DatabaseCheck::Tables {
  SqliteFile file;
  Statement tasks;
  bool more = true;  // rows of the table `task`
  TraitTable traits;
};

DatabaseCheck::DatabaseCheck(const std::filesystem::path& folder) {
  const auto path = path_inside(folder, kFile, MissingFolders::Refused);
  if (!path) {
    fail(path.error().message);
    return;
  }
  try {
    SqliteFile file(*path, SqliteFile::Mode::Read);
    auto tasks = file.prepare(
        "SELECT id, template, split, simulator, scene, layout, goal, instruction, style, writer, steps, failures FROM "
        "task ORDER BY rowid");
    auto traits = TraitTable::open(*path);
    if (!traits) {
      fail(traits.error().message);
      return;
    }
    tables_ = std::make_unique<Tables>(Tables{std::move(file), std::move(tasks), true, std::move(*traits)});
  } catch (const std::exception& reason) {
    fail(reason.what());
  }
}

DatabaseCheck::~DatabaseCheck() = default;

void DatabaseCheck::fail(const std::string& reason) {
  problems_.push_back(wrong("", "cannot be read: " + reason));
  tables_.reset();
}

void DatabaseCheck::add(const TaskReading& task, const TaskFacts& facts) {
  ++tasks_;
  bindings_ += static_cast<std::int64_t>(task.record->bindings.size());
  for (const auto& shown : task.record->expert) steps_ += shown.steps;
  if (!tables_) return;
  try {
    tables_->more = tables_->more && tables_->tasks.step();
    if (tables_->more) {
      ++rows_;
      if (const auto field = difference(tables_->tasks, *task.record); !field.empty())
        problems_.push_back(wrong(task.name, "has a different " + field + " for this task than tasks.jsonl"));
    }
    const auto traits = tables_->traits.of(tasks_, task.name);
    if (!traits) return fail(traits.error().message);
    if (!facts.start_key.empty()) check_traits(task, facts, *traits, problems_);
    for (const auto& [dimension, value] : *traits) ++traits_[dimension][value];
  } catch (const std::exception& reason) {
    fail(reason.what());
  }
}

std::vector<Problem> DatabaseCheck::finish(std::int64_t rejections) {
  if (!tables_) return std::move(problems_);
  try {
    while (tables_->more && tables_->tasks.step()) ++rows_;
    compare_count("task", rows_, tasks_, problems_);
    compare_count("binding", count(tables_->file, "SELECT count(*) FROM binding"), bindings_, problems_);
    compare_count("step", count(tables_->file, "SELECT count(*) FROM step"), steps_, problems_);
    compare_count("rejection", count(tables_->file, "SELECT count(*) FROM rejection"), rejections, problems_);
  } catch (const std::exception& reason) {
    fail(reason.what());
  }
  return std::move(problems_);
}

}  // namespace unietp
