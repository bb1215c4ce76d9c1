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

/// Reads the table `trait` of dataset.sqlite: the properties over which a data set is balanced, by task. Memory use
/// does not depend on the number of tasks.
class TraitTable {
 public:
  using Traits = std::vector<std::pair<std::string, std::string>>;  // dimension, value; in the order of the table

  /// Errors: Io, for a file that is not such a database.
  static Result<TraitTable> open(const std::filesystem::path& file);

  /// The traits of a task, which must be row `row` (from 1) of the table `task`; call it with rising rows. Empty when
  /// that row belongs to a different task. Errors: Io.
  Result<Traits> of(std::int64_t row, const std::string& task);

 private:
  TraitTable(std::filesystem::path path, SqliteFile file, Statement rows)
      : path_(std::move(path)), file_(std::move(file)), rows_(std::move(rows)) {}

  std::filesystem::path path_;
  SqliteFile file_;
  Statement rows_;
  bool begun_ = false, more_ = false;  // more_: the current row was not returned yet
};

/// The numbers for all tasks. Errors: Io, as above.
Result<TraitCounts> trait_counts(const std::filesystem::path& file);

}  // namespace unietp
