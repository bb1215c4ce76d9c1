#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/result.h"
#include "dataset/balance.h"
#include "dataset/candidate.h"
#include "dataset/configuration.h"
#include "dataset/dataset_counts.h"
#include "dataset/dataset_database.h"
#include "dataset/lines.h"
#include "dataset/manifest.h"
#include "resources/resources.h"

namespace unietp {

/// "homes/<layout>.scene.json.gz"
std::string home_entry(const std::string& layout);

/// Writes a data set's folder (docs/files.md), task by task. Equal input gives equal bytes.
class DatasetWriter {
 public:
  /// Errors, here and below: Io.
  static Result<DatasetWriter> begin(const std::filesystem::path& folder);

  /// The packed scene of a home.
  using HomeSource = std::function<Result<std::string>(const std::string& layout)>;
  /// Call in slot order; rejections of a slot in order of attempt. `homes` is called for the first task of each home.
  Result<Done> add_task(const WrittenTask& task, const std::vector<Trait>& traits, const HomeSource& homes);
  Result<Done> add_rejection(const RejectionEntry& rejection);
  /// The database, the card and the manifest; after it the folder is complete. `writing`: how the instructions were
  /// written anew, if they were; `reviews`: the verdicts, if there are any. Errors: also those of sources_of.
  Result<Done> finish(const RunConfiguration& configuration, const Resources& resources,
                      const std::filesystem::path& licenses, std::optional<WritingEntry> writing = {},
                      std::optional<ReviewCounts> reviews = {});

 private:
  DatasetWriter(std::filesystem::path folder, LinesWriter tasks, LinesWriter rejections, DatasetDatabase database)
      : folder_(std::move(folder)),
        tasks_(std::move(tasks)),
        rejections_(std::move(rejections)),
        database_(std::move(database)) {}

  Result<Done> add_home(const std::string& layout, const HomeSource& homes);
  Result<Done> add_demonstration(Mode mode, const std::string& line);

  std::filesystem::path folder_;
  LinesWriter tasks_, rejections_;
  std::map<Mode, LinesWriter> demonstrations_;
  DatasetDatabase database_;
  DatasetCounts counts_;
  Frequencies traits_;           // of the tasks
  std::set<std::string> homes_;  // that are written
};

}  // namespace unietp
