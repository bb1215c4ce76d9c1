#pragma once

#include <map>
#include <string>
#include <string_view>
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
};

struct RecordedSpread {
  std::string dimension;
  int values = 0;
  double effective = 0, variation = 0;
};

struct RecordedFile {
  std::string sha256;
  double bytes = 0;
};

struct ManifestRecord {
  std::string knowledge_digest;
  RecordedRun run;
  std::string phrasings;  // of the texts now: what `annotate` recorded, else the run's
  int tasks = 0, candidates = 0;
  std::map<std::string, int> by_split, by_simulator, by_template;
  std::map<std::string, int> rejections;  // by "stage reason"
  std::vector<RecordedSpread> balance;
  std::map<std::string, RecordedFile> files;  // by path
};

/// Errors: Parse, Schema with a JSON pointer.
Result<ManifestRecord> read_manifest(std::string_view where, std::string_view text);

}  // namespace unietp
