#include "validator/task_rows.h"

#include "core/text.h"

namespace unietp {
namespace {

std::string selection(const std::string& table, const std::vector<std::string>& columns) {
  std::vector<std::string> names;
  for (const auto& column : columns) names.push_back("own." + column);
  return "SELECT ifnull(task.rowid, 0), own.rowid, " + join(names, ", ") + " FROM " + table +
         " AS own LEFT JOIN task ON task.id = own.task ORDER BY 1, 2";
}

}  // namespace

TaskRows::TaskRows(SqliteFile& file, const std::string& table, const std::vector<std::string>& columns)
    : table_(table), columns_(columns.size()), rows_(file.prepare(selection(table, columns))) {
  step();
}

void TaskRows::step() { more_ = rows_.step(); }

std::vector<TextRow> TaskRows::of(std::int64_t row) {
  std::vector<TextRow> found;
  for (; more_ && rows_.integer(0) <= row; step()) {
    in_order_ = in_order_ && rows_.integer(1) == ++read_;
    if (rows_.integer(0) != row) continue;
    TextRow& texts = found.emplace_back();
    for (std::size_t i = 0; i < columns_; ++i) texts.emplace_back(rows_.text(static_cast<int>(i) + 2));
  }
  return found;
}

}  // namespace unietp
