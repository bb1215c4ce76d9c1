#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "annotator/instruction.h"
#include "core/result.h"
#include "core/sqlite_file.h"
#include "dataset/lines.h"
#include "dataset/task_row.h"

namespace unietp {

struct Trait;

/// `dataset.sqlite`: the lines of a data set as tables, for queries. Equal input gives equal bytes: rows are inserted
/// in file order and the finished file is a VACUUM copy, which does not depend on the history of the file.
class DatasetDatabase {
 public:
  /// Errors, here and below: Io.
  static Result<DatasetDatabase> begin(const std::filesystem::path& path);
  /// `traits`: the properties over which the data set is balanced (balance.h); they are not in the task's line.
  Result<Done> add_task(const TaskRow& task, const std::vector<Trait>& traits);
  Result<Done> add_rejection(const RejectionEntry& rejection);
  /// Writes the file; nothing may be added afterwards.
  Result<Done> finish();

 private:
  DatasetDatabase(std::filesystem::path path, SqliteFile file) : path_(std::move(path)), file_(std::move(file)) {}
  std::filesystem::path path_;
  SqliteFile file_;
};

/// A copy of such a database with other instructions. Equal input gives equal bytes, as above.
class RewordedDatabase {
 public:
  /// Errors, here and below: Io.
  static Result<RewordedDatabase> begin(const std::filesystem::path& from, const std::filesystem::path& to);
  /// `task`: its id.
  Result<Done> add(const std::string& task, const Instruction& instruction);
  /// Writes the file; nothing may be added afterwards.
  Result<Done> finish();

 private:
  RewordedDatabase(std::filesystem::path from, std::filesystem::path to, SqliteFile file, Statement update)
      : from_(std::move(from)), to_(std::move(to)), file_(std::move(file)), update_(std::move(update)) {}
  std::filesystem::path from_, to_;
  SqliteFile file_;
  Statement update_;
};

}  // namespace unietp
