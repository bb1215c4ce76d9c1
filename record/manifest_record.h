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

/// The configuration in the manifest, as far as the files can be compared with it.
struct RecordedRun {
  int count = 0;
  std::uint64_t seed = 0;
  std::vector<std::string> simulators, splits;        // empty splits: all
  std::vector<std::string> templates, without;        // empty templates: all
  std::map<std::string, int> by_split, by_simulator;  // quotas; both empty: equal shares
  std::vector<Mode> modes;
  std::string phrasings;             // "everyday", "all", "training", "benchmark"
  std::string english = "us";        // or "gb"
  std::string sense;                 // "usual", "tolerable", "any"
  std::string homes;                 // "benchmark", "training", "drawn"
  int attempts = 0;                  // candidates tried for one task
  int block = 0;                     // tasks planned together
  int rooms = 0, objects = 0;        // of a drawn home
  std::vector<std::string> scenes;   // given homes, "<id> <sha256 of its JSON>"
  std::vector<std::string> own;      // the user's own templates, "<name> <sha256>"
  std::vector<std::string> binding;  // "A=Mug", of every task
  bool extended = false;             // with the extended library, whose agents have the profile `wide`
  bool native = false;               // only tasks that their simulators can express, in scenes of their own
  std::string text;                  // the whole configuration as compact JSON: `unietp-run/1`
};

/// How `annotate` wrote the instructions.
struct RecordedWriting {
  std::string writer;
  std::optional<std::uint64_t> seed;
  std::string phrasings;
  std::string english = "us";                       // or "gb"
  std::vector<std::pair<std::string, int>> counts;  // writer of the instruction, tasks
  /// How wordings.jsonl was written.
  struct Pairs {
    int wordings = 0;  // texts of each task's goal that were asked for
    bool contrasts = false;
  };
  std::optional<Pairs> pairs;  // nullopt: there is no such file
};

/// Verdicts in reviews.jsonl.
struct RecordedReviews {
  int accepted = 0, rejected = 0, edited = 0;
  bool operator==(const RecordedReviews&) const = default;
};

/// A source of facts with its license.
struct RecordedSource {
  std::string source, origin, license;
};

/// How evenly the tasks are distributed over the values of a dimension.
struct RecordedSpread {
  std::string dimension;
  int values = 0;
  double effective = 0, variation = 0;
};

/// A file of the data set.
struct RecordedFile {
  std::string sha256;
  std::uint64_t bytes = 0;
};

/// manifest.json of a data set.
struct ManifestRecord {
  std::string program_name, program_version;
  std::string knowledge_digest;
  std::string benchmark;  // the frozen benchmark that the tasks are; "": none
  RecordedRun run;
  std::string phrasings, english;  // of the present instructions
  int tasks = 0, candidates = 0;
  std::map<std::string, int> by_split, by_simulator, by_template, by_sense, by_form;
  std::map<std::string, int> not_usual;                          // by template
  std::map<std::string, std::map<std::string, int>> rejections;  // by stage and reason
  std::vector<RecordedSpread> balance;
  std::map<std::string, RecordedFile> files;  // by path
  std::vector<RecordedSource> sources;
  std::optional<RecordedWriting> writing;  // nullopt: the run wrote the instructions
  std::optional<RecordedReviews> reviews;  // nullopt: nobody reviewed it
};

/// Reads the text of a manifest. Errors: Parse, Schema with a JSON pointer.
Result<ManifestRecord> read_manifest(std::string_view where, std::string_view text);

/// Reads manifest.json in a data set's folder. Errors: also Io.
Result<ManifestRecord> read_manifest_file(const std::filesystem::path& folder);

/// Whether the manifest of a folder records the extended library. False if it cannot be read.
bool records_extended_library(const std::filesystem::path& folder);

}  // namespace unietp
