#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/sqlite_file.h"
#include "validator/text_row.h"

namespace unietp {

/// Reads a table of dataset.sqlite whose column `task` names a task, task by task in the order of the table `task`.
/// Memory: the rows of one task. Throws std::runtime_error as Statement does.
class TaskRows {
 public:
  /// `columns` besides `task`. `file` must outlive it.
  TaskRows(SqliteFile& file, const std::string& table, const std::vector<std::string>& columns);

  /// The rows of the task that is row `row` (from 1) of the table `task`, in the table's order; call it with rising
  /// rows. Rows of no task come with row 0.
  std::vector<TextRow> of(std::int64_t row);
  /// Whether all rows so far stand in the table in the order in which they were read here.
  bool in_order() const { return in_order_; }
  const std::string& table() const { return table_; }

 private:
  void step();

  std::string table_;
  std::size_t columns_;
  Statement rows_;
  bool more_ = false, in_order_ = true;
  std::int64_t read_ = 0;
};

}  // namespace unietp
