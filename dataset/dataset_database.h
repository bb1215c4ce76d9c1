#pragma once

#include <filesystem>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "core/result.h"
#include "core/sqlite_file.h"

namespace unietp {

struct Trait;

/// `dataset.sqlite`: the lines of a data set as tables, for queries. Equal input gives equal bytes: rows are inserted
/// in file order and the finished file is a VACUUM copy, which leaves no trace of how it grew.
class DatasetDatabase {
 public:
  static Result<DatasetDatabase> begin(const std::filesystem::path& path);
  /// `traits`: what the data set is kept level over (balance.h), which the task's line does not say.
  Result<Done> add_task(const nlohmann::ordered_json& task, const std::vector<nlohmann::ordered_json>& demonstrations,
                        const std::vector<Trait>& traits);
  Result<Done> add_rejection(const nlohmann::ordered_json& rejection);
  Result<Done> finish();

 private:
  DatasetDatabase(std::filesystem::path path, SqliteFile file) : path_(std::move(path)), file_(std::move(file)) {}
  std::filesystem::path path_;
  SqliteFile file_;
};

}  // namespace unietp
