#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/result.h"
#include "dataset/configuration.h"
#include "dataset/dataset_counts.h"
#include "resources/resources.h"

namespace unietp {

/// A file of a data set.
struct FileEntry {
  std::uint64_t bytes = 0;
  std::string sha256;
};

/// A source of facts behind a data set.
struct SourceLicense {
  std::string source;   // "metadata:ai2thor/object_types.json", "curated"
  std::string origin;   // repository it was collected from
  std::string license;  // as found there
};

/// How `annotate` wrote wordings.jsonl.
struct PairsEntry {
  std::size_t wordings = 0;  // texts of each task's goal that were asked for
  bool contrasts = false;
  bool operator==(const PairsEntry&) const = default;
};

/// How `annotate` wrote the instructions after the run.
struct WritingEntry {
  std::string writer;
  std::optional<std::uint64_t> seed;                // of the wording, where it is not the run's
  std::string phrasings;                            // "everyday", "all", "training" or "benchmark"
  std::string english;                              // "us" or "gb"
  std::vector<std::pair<std::string, int>> counts;  // writer of an instruction, tasks
  std::optional<PairsEntry> pairs = {};             // nullopt: there is no wordings.jsonl
};

/// Verdicts in reviews.jsonl.
struct ReviewCounts {
  int accepted = 0, rejected = 0, edited = 0;
};

/// manifest.json of a data set.
struct Manifest {
  std::string version;           // of the program
  std::string knowledge_digest;  // of the tables, profiles, layouts and templates
  std::string benchmark;         // the frozen benchmark that the tasks are; "": none
  RunConfiguration configuration;
  DatasetCounts counts;
  std::map<std::string, FileEntry> files;  // by path in the folder, but for the manifest
  std::vector<SourceLicense> sources;
  std::optional<WritingEntry> writing;  // nullopt: the run wrote the instructions
  std::optional<ReviewCounts> reviews;  // nullopt: nobody reviewed it
};
/// The frozen benchmark that a data set with these files is, or "".
std::string benchmark_of(const std::map<std::string, FileEntry>& files, const FrozenBenchmarks& frozen);

/// The text of manifest.json.
std::string to_text(const Manifest& manifest);

/// All files below a folder. Errors: Io.
Result<std::map<std::string, FileEntry>> files_below(const std::filesystem::path& folder);

/// The sources that the facts of the configuration's simulators name, sorted, with what the table says of each.
/// Errors: Io, Parse; Schema when a metadata source has no row (a license is never guessed).
Result<std::vector<SourceLicense>> sources_of(const RunConfiguration& configuration, const Resources& resources,
                                              const std::filesystem::path& table);

}  // namespace unietp
