#include "validator/database_check.h"

#include <algorithm>
#include <array>
#include <exception>
#include <string_view>

#include "core/file_place.h"
#include "core/sqlite_file.h"
#include "core/text.h"
#include "validator/recount.h"
#include "validator/task_rows.h"

namespace unietp {
namespace {

constexpr const char* kDatabaseFile = "dataset.sqlite";

/// All that the schema of the database holds, with single blanks, in order of name. What SQLite adds by itself has no
/// text.
constexpr std::array<std::string_view, 5> kTables{
    "CREATE TABLE binding(task TEXT NOT NULL REFERENCES task, placeholder TEXT NOT NULL, category TEXT NOT NULL) "
    "STRICT",
    "CREATE TABLE rejection(slot INTEGER NOT NULL, attempt INTEGER NOT NULL, template TEXT NOT NULL, simulator TEXT "
    "NOT NULL, split TEXT NOT NULL, stage TEXT NOT NULL, reason TEXT NOT NULL, detail TEXT NOT NULL) STRICT",
    "CREATE TABLE step(task TEXT NOT NULL REFERENCES task, mode TEXT NOT NULL, number INTEGER NOT NULL, action TEXT "
    "NOT NULL, arguments TEXT NOT NULL, success INTEGER NOT NULL, failure TEXT NOT NULL) STRICT",
    "CREATE TABLE task(id TEXT PRIMARY KEY, template TEXT NOT NULL, split TEXT NOT NULL, simulator TEXT NOT NULL, "
    "scene "
    "TEXT NOT NULL, layout TEXT NOT NULL, goal TEXT NOT NULL, instruction TEXT NOT NULL, style TEXT NOT NULL, writer "
    "TEXT NOT NULL, sense TEXT NOT NULL, forms TEXT NOT NULL, steps INTEGER NOT NULL, failures INTEGER NOT NULL) "
    "STRICT",
    "CREATE TABLE trait(task TEXT NOT NULL REFERENCES task, dimension TEXT NOT NULL, value TEXT NOT NULL) STRICT"};

Problem database_problem(const std::string& task, std::string message) {
  auto problem = problem_in(ProblemKind::Database, kDatabaseFile, std::move(message));
  problem.task = task;
  return problem;
}

std::string with_single_blanks(std::string_view text) {
  std::string single;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\n' || c == '\t';
    if (!blank) single += c;
    if (blank && !single.empty() && single.back() != ' ') single += ' ';
  }
  return single;
}

ProblemList compare_schema(SqliteFile& file) {
  ProblemList problems;
  auto entries = file.prepare("SELECT sql FROM sqlite_master WHERE sql IS NOT NULL ORDER BY name");
  std::vector<std::string> found;
  while (entries.step()) found.push_back(with_single_blanks(entries.text(0)));
  for (const auto& one : found) {
    if (std::find(kTables.begin(), kTables.end(), one) == kTables.end())
      problems.add(database_problem("", "has \"" + one + "\" in its schema, which no data set has"));
  }
  for (const auto table : kTables) {
    if (std::find(found.begin(), found.end(), table) == found.end())
      problems.add(database_problem("", "lacks \"" + std::string(table) + "\" in its schema"));
  }
  return problems;
}

/// What a file says beside its tables, where readers of values do not look.
struct Aside {
  const char* pragma;
  std::string_view value;
};
constexpr std::uintmax_t kPageBytes = 4096;
constexpr Aside kAside[] = {{"application_id", "0"}, {"user_version", "0"}, {"page_size", "4096"},
                            {"encoding", "UTF-8"},   {"auto_vacuum", "0"},  {"freelist_count", "0"}};

ProblemList check_around_tables(SqliteFile& file, std::uintmax_t bytes) {
  ProblemList problems;
  const auto value = [&](const char* pragma) {
    auto row = file.prepare(std::string("PRAGMA ") + pragma);
    return row.step() ? std::string(row.text(0)) : "";
  };
  for (const auto& [pragma, wanted] : kAside) {
    if (const auto found = value(pragma); found != wanted)
      problems.add(
          database_problem("", std::string("has the ") + pragma + " " + found + ", expected " + std::string(wanted)));
  }
  if (const auto pages = value("page_count"); std::to_string(bytes / kPageBytes) != pages || bytes % kPageBytes != 0)
    problems.add(database_problem(
        "", "has " + std::to_string(bytes) + " bytes, expected " + pages + " pages of " + std::to_string(kPageBytes)));
  if (const auto fault = value("quick_check"); fault != "ok")
    problems.add(database_problem("", "is damaged: " + fault));
  return problems;
}

/// A table's columns with the values that a row must have.
using NamedValues = std::vector<std::pair<const char*, std::string>>;

NamedValues values_of(const TaskRecord& task) {
  NamedValues values{{"id", task.id},          {"template", task.template_name},
                     {"split", task.split},    {"simulator", task.simulator},
                     {"scene", task.scene},    {"layout", task.layout},
                     {"goal", task.goal_text}, {"instruction", task.instruction},
                     {"style", task.style},    {"writer", task.writer},
                     {"sense", task.grade},    {"forms", join(task.forms, " ")}};
  if (task.expert.empty()) return values;
  values.emplace_back("steps", std::to_string(task.expert.front().steps));
  values.emplace_back("failures", std::to_string(task.expert.front().failures));
  return values;
}

NamedValues values_of(const RejectionRecord& rejection) {
  return {{"slot", std::to_string(rejection.slot)},
          {"attempt", std::to_string(rejection.attempt)},
          {"template", rejection.template_name},
          {"simulator", rejection.simulator},
          {"split", rejection.split},
          {"stage", rejection.stage},
          {"reason", rejection.reason},
          {"detail", rejection.detail}};
}

/// The first column in which a row differs; "" when there is none.
std::string difference(Statement& row, const NamedValues& values) {
  int column = 0;
  for (const auto& [name, value] : values) {
    if (row.text(column++) != value) return name;
  }
  return "";
}

std::string row_text(const TextRow& row) { return "(" + join(row, ", ") + ")"; }

/// The first difference between the rows of a task and what the files have; "" when there is none.
std::string difference(const std::vector<TextRow>& there, const std::vector<TextRow>& wanted) {
  for (std::size_t i = 0; i < std::min(there.size(), wanted.size()); ++i) {
    if (there[i] != wanted[i]) return "has " + row_text(there[i]) + " where the files have " + row_text(wanted[i]);
  }
  if (there.size() == wanted.size()) return "";
  return "has " + std::to_string(there.size()) + " rows of this task, expected " + std::to_string(wanted.size());
}

std::vector<TextRow> rows_of_bindings(const TaskRecord& task) {
  std::vector<TextRow> rows;
  for (const auto& [placeholder, category] : task.bindings) rows.push_back({placeholder, category});
  return rows;
}

/// What the traits of a task must be. Whether a bound category counts as a receptacle is up to its template; one that
/// does has no use.
class TraitRules {
 public:
  TraitRules(const TaskRecord& task, const TaskFacts& facts) : facts_(facts) {
    wanted_.emplace("template", task.template_name);
    wanted_.emplace("scene", task.layout);
    for (const auto& room : facts.rooms) wanted_.emplace("room", room);
    for (const auto& room : facts.bound_rooms) wanted_.emplace("room", room);
  }

  /// What is wrong with the rows; "" when nothing is.
  std::string fault(const std::vector<TextRow>& rows) {
    std::set<std::string> categories = facts_.bound_categories;
    for (const TextRow& row : rows) {
      if (const auto use = facts_.uses.find(row[1]); row[0] == "category" && use != facts_.uses.end())
        wanted_.emplace("use", use->second);
    }
    std::pair<std::ptrdiff_t, std::string> last{-1, ""};
    for (const TextRow& row : rows) {
      const auto place = std::find(kDimensions.begin(), kDimensions.end(), row[0]) - kDimensions.begin();
      if (std::pair(place, row[1]) <= last) return "lists " + row_text(row) + " out of order";
      last = {place, row[1]};
      const bool category = row[0] == "category" || row[0] == "receptacle";
      if (category ? !facts_.bound_categories.contains(row[1]) : wanted_.erase({row[0], row[1]}) == 0)
        return "lists " + row_text(row) + ", which this task is not";
      if (category) categories.erase(row[1]);
    }
    if (!wanted_.empty()) return "does not list the " + wanted_.begin()->first + " " + wanted_.begin()->second;
    return categories.empty() ? "" : "does not list the category " + *categories.begin();
  }

 private:
  const TaskFacts& facts_;
  std::set<std::pair<std::string, std::string>> wanted_;  // that are not listed yet
};

}  // namespace

struct DatabaseCheck::Tables {
  explicit Tables(const std::filesystem::path& path)
      : file(path, SqliteFile::Mode::Read),
        tasks(file.prepare(
            "SELECT id, template, split, simulator, scene, layout, goal, instruction, style, writer, sense, forms, "
            "steps, failures FROM task ORDER BY rowid")),
        rejections(file.prepare("SELECT slot, attempt, template, simulator, split, stage, reason, detail FROM "
                                "rejection ORDER BY rowid")),
        bindings(file, "binding", {"placeholder", "category"}),
        steps(file, "step", {"mode", "number", "action", "arguments", "success", "failure"}),
        traits(file, "trait", {"dimension", "value"}) {}

  SqliteFile file;
  Statement tasks, rejections;
  TaskRows bindings, steps, traits;
};

DatabaseCheck::DatabaseCheck(const std::filesystem::path& folder) {
  const auto path = path_inside(folder, kDatabaseFile, MissingFolders::Refused);
  if (!path) {
    fail(path.error().message);
    return;
  }
  try {
    tables_ = std::make_unique<Tables>(*path);
    problems_.add(compare_schema(tables_->file));
    problems_.add(check_around_tables(tables_->file, std::filesystem::file_size(*path)));
    for (TaskRows* rows : {&tables_->bindings, &tables_->steps, &tables_->traits}) {
      if (!rows->of(0).empty())
        problems_.add(database_problem("", "has rows of unknown tasks in the table " + rows->table()));
    }
  } catch (const std::exception& reason) {
    fail(reason.what());
  }
}

DatabaseCheck::~DatabaseCheck() = default;

void DatabaseCheck::fail(const std::string& reason) {
  problems_.add(database_problem("", "cannot be read: " + reason));
  tables_.reset();
}

void DatabaseCheck::add(const TaskReading& task, const TaskFacts& facts) {
  const std::int64_t row = ++tasks_;
  if (!tables_) return;
  const auto found = [&](std::string fault) {
    if (!fault.empty()) problems_.add(database_problem(task.name, std::move(fault)));
  };
  const auto in_table = [](const char* table, const std::string& fault) {
    return fault.empty() ? fault : "the table " + std::string(table) + " " + fault;
  };
  try {
    if (!tables_->tasks.step()) {
      found("has no row for this task");
    } else if (const auto field = difference(tables_->tasks, values_of(*task.record)); !field.empty()) {
      found("has a different " + field + " for this task than tasks.jsonl");
    }
    found(in_table("binding", difference(tables_->bindings.of(row), rows_of_bindings(*task.record))));
    const auto steps = tables_->steps.of(row);
    if (facts.steps) found(in_table("step", difference(steps, *facts.steps)));
    const auto traits = tables_->traits.of(row);
    if (!facts.start_key.empty()) found(in_table("trait", TraitRules(*task.record, facts).fault(traits)));
    for (const TextRow& trait : traits) ++traits_[trait[0]][trait[1]];
  } catch (const std::exception& reason) {
    fail(reason.what());
  }
}

void DatabaseCheck::add(const RejectionRecord& rejection) {
  ++rejections_;
  if (!tables_) return;
  try {
    if (!tables_->rejections.step()) {
      problems_.add(
          database_problem("", "has no row for line " + std::to_string(rejections_) + " of rejections.jsonl"));
    } else if (const auto field = difference(tables_->rejections, values_of(rejection)); !field.empty()) {
      problems_.add(database_problem("", "has a different " + field + " in row " + std::to_string(rejections_) +
                                             " of the table rejection than rejections.jsonl"));
    }
  } catch (const std::exception& reason) {
    fail(reason.what());
  }
}

ProblemList DatabaseCheck::finish() {
  if (!tables_) return std::move(problems_);
  try {
    if (tables_->tasks.step()) problems_.add(database_problem("", "has more tasks than tasks.jsonl"));
    if (tables_->rejections.step())
      problems_.add(database_problem("", "has more rows in the table rejection than rejections.jsonl"));
    for (const TaskRows* rows : {&tables_->bindings, &tables_->steps, &tables_->traits}) {
      if (!rows->in_order())
        problems_.add(
            database_problem("", "the rows of the table " + rows->table() + " are not in the order of the tasks"));
    }
  } catch (const std::exception& reason) {
    fail(reason.what());
  }
  return std::move(problems_);
}

}  // namespace unietp
