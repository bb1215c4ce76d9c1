#include "table_changes.h"

#include "core/sqlite_file.h"
#include "core/text.h"

namespace unietp {
namespace {

struct Column {
  std::string name;
  bool number = false;
};

std::vector<Column> columns_of(SqliteFile& file, const std::string& table) {
  std::vector<Column> columns;
  auto rows = file.prepare("SELECT name, type FROM pragma_table_info('" + table + "')");
  while (rows.step()) columns.push_back({std::string(rows.text(0)), rows.text(1) == "INTEGER"});
  return columns;
}

std::string names_of(const std::vector<Column>& columns) {
  std::vector<std::string> names;
  for (const Column& column : columns) names.push_back(column.name);
  return join(names, ", ");
}

void add_changes_of_row(const std::string& table, const std::vector<Column>& columns, int row,
                        std::vector<TableChange>& changes) {
  const std::string at = " WHERE rowid = " + std::to_string(row);
  for (const auto& [column, number] : columns) {
    const std::string field = table + "." + column, set = "UPDATE " + table + " SET " + column + " = ";
    const auto add = [&](const char* how, const std::string& value) {
      changes.push_back({field, how, set + value + at});
    };
    add("plus one", number ? column + " + 1" : column + " || 'x'");
    if (number) {
      add("twice", "CASE " + column + " WHEN 0 THEN 2 ELSE 2 * " + column + " END");
    } else if (table != "task" || column != "id") {
      // Where the column has one value only, nothing changes; then the first letter goes.
      add("another value", "ifnull((SELECT o." + column + " FROM " + table + " AS o WHERE o." + column + " <> " +
                               table + "." + column + " ORDER BY (o.rowid + " + std::to_string(row) +
                               ") % 17, o.rowid LIMIT 1), substr(" + column + ", 2) || '_')");
    }
  }
  changes.push_back({table, "row dropped", "DELETE FROM " + table + at});
  const std::string names = names_of(columns);
  if (table != "task")
    changes.push_back(
        {table, "row doubled", "INSERT INTO " + table + "(" + names + ") SELECT " + names + " FROM " + table + at});
  changes.push_back({table, "rows swapped",
                     "UPDATE " + table + " SET rowid = -1" + at + "; UPDATE " + table +
                         " SET rowid = " + std::to_string(row) + " WHERE rowid = " + std::to_string(row + 1) +
                         "; UPDATE " + table + " SET rowid = " + std::to_string(row + 1) + " WHERE rowid = -1"});
}

}  // namespace

std::vector<TableChange> changes_of_database(const std::filesystem::path& file, int rows_of_a_table) {
  SqliteFile database(file, SqliteFile::Mode::Read);
  std::vector<TableChange> changes;
  for (const std::string table : {"task", "binding", "step", "trait", "rejection"}) {
    auto counted = database.prepare("SELECT count(*) FROM " + table);
    counted.step();
    const auto count = static_cast<int>(counted.integer(0));
    const auto columns = columns_of(database, table);
    const int rows = std::min(rows_of_a_table, count - 1);
    for (int i = 0; i < rows; ++i) add_changes_of_row(table, columns, 1 + i * (count - 1) / rows, changes);
    changes.push_back({table, "a column more", "ALTER TABLE " + table + " ADD COLUMN surprise TEXT"});
  }
  changes.push_back({"", "a table more", "CREATE TABLE surprise(a TEXT) STRICT"});
  changes.push_back({"", "an index more", "CREATE INDEX surprise ON task(goal)"});
  changes.push_back({"", "a view more", "CREATE VIEW surprise AS SELECT 1"});
  return changes;
}

}  // namespace unietp
