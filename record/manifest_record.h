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
#include "scene/action.h"

namespace unietp {

/// The manifest's name in a data set's folder.
inline constexpr const char* kManifest = "manifest.json";

/// What the manifest says of the run, as far as the files can be held against it.
struct RecordedRun {
  int count = 0;
  std::uint64_t seed = 0;
  std::vector<std::string> simulators, splits;        // empty splits: all
  std::vector<std::string> templates, without;        // empty templates: all
  std::map<std::string, int> by_split, by_simulator;  // quotas; both empty: shares are level
  std::vector<Mode> modes;
  std::string phrasings;  // "all", "training", "benchmark"
  std::string homes;
  bool extended = false;  // the extended library was used, whose agents have the profile `wide`
  std::string text;       // the whole configuration as compact JSON: `unietp-run/1`
};

/// How the instructions were written when that was done anew, by `annotate`.
struct RecordedWriting {
  std::string writer;
  std::optional<std::uint64_t> seed;
  std::string phrasings = "all";
  std::vector<std::pair<std::string, int>> counts;  // writer of the instruction, tasks
};

struct RecordedSource {
  std::string source, origin, licence;
};

/// How evenly the tasks lie over the values of a dimension.
struct RecordedSpread {
  std::string dimension;
  int values = 0;
  double effective = 0, variation = 0;
};

struct RecordedFile {
  std::string sha256;
  std::uint64_t bytes = 0;
};

/// manifest.json of a data set.
struct ManifestRecord {
  std::string program_name, program_version;
  std::string knowledge_digest;
  RecordedRun run;
  std::string phrasings;  // of the texts now: what `annotate` recorded, else the run's
  int tasks = 0, candidates = 0;
  std::map<std::string, int> by_split, by_simulator, by_template;
  std::map<std::string, std::map<std::string, int>> rejections;  // by stage and reason
  std::vector<RecordedSpread> balance;
  std::map<std::string, RecordedFile> files;  // by path
  std::vector<RecordedSource> sources;
  std::optional<RecordedWriting> writing;  // nullopt: the run wrote the instructions
};

/// Errors: Parse, Schema with a JSON pointer.
Result<ManifestRecord> read_manifest(std::string_view where, std::string_view text);

/// manifest.json of a data set's folder. Errors: also Io.
Result<ManifestRecord> read_manifest_file(const std::filesystem::path& folder);

/// Whether the manifest of a folder records the extended library. False for one that does not read.
bool records_extended_library(const std::filesystem::path& folder);

}  // namespace unietp
