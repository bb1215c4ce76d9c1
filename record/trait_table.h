#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/result.h"
#include "core/sqlite_file.h"

namespace unietp {

/// How many tasks have each value of each dimension: "receptacle", "ai2thor/Sofa".
using TraitCounts = std::map<std::string, std::map<std::string, int>>;

/// The table `trait` of dataset.sqlite, which states what each task counts as when a data set is balanced. It is read
/// in the order of the table `task`, in bounded memory.
class TraitTable {
 public:
  using Traits = std::vector<std::pair<std::string, std::string>>;  // dimension, value; in the order of the table

  /// Errors: Io, for a file that is no such database.
  static Result<TraitTable> open(const std::filesystem::path& file);

  /// The traits of a task, which is the row `row` (from 1) of the table `task`; rows are asked for in rising order.
  /// Empty where that row is another task's. Errors: Io.
  Result<Traits> of(std::int64_t row, const std::string& task);

 private:
  TraitTable(std::filesystem::path path, SqliteFile file, Statement rows)
      : path_(std::move(path)), file_(std::move(file)), rows_(std::move(rows)) {}

  std::filesystem::path path_;
  SqliteFile file_;
  Statement rows_;
  bool begun_ = false, more_ = false;  // more_: `rows_` stands at a row that was not given out
};

/// Of all tasks. Errors: Io, as above.
Result<TraitCounts> trait_counts(const std::filesystem::path& file);

}  // namespace unietp
