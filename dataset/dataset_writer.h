#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "core/result.h"
#include "dataset/candidate.h"
#include "dataset/configuration.h"
#include "dataset/dataset_counts.h"
#include "dataset/dataset_database.h"
#include "resources/resources.h"

namespace unietp {

/// Writes a data set's folder (docs/files.md), task by task. Equal input gives equal bytes.
class DatasetWriter {
 public:
  /// Errors: Io.
  static Result<DatasetWriter> begin(const std::filesystem::path& folder);

  /// The packed scene of a home.
  using HomeSource = std::function<Result<std::string>(const std::string& layout)>;
  /// In slot order; a slot's rejections in order of attempt. A home is asked for with its first task.
  Result<Done> add_task(const CandidateRecord& record, const HomeSource& homes);
  Result<Done> add_rejection(const std::string& line);
  /// The manifest, the database and the card; after it the folder is complete.
  Result<Done> finish(const RunConfiguration& configuration, const Resources& resources,
                      const std::filesystem::path& licences);

 private:
  DatasetWriter(std::filesystem::path folder, DatasetDatabase database);
  std::filesystem::path folder_;
  Result<Done> add_home(const std::string& layout, const HomeSource& homes);
  Result<Done> add_demonstration(const std::string& mode, const std::string& line);
  std::ofstream tasks_, rejections_;
  std::map<std::string, std::ofstream> demonstrations_;  // by mode
  DatasetDatabase database_;
  DatasetCounts counts_;
  std::set<std::string> homes_;  // that are written
};

}  // namespace unietp
