#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "environment/settings.h"

namespace unietp {

/// The manifest's name in an evaluation's folder.
inline constexpr const char* kEvaluationManifest = "manifest.json";
/// The backend that is the program's own physics. Every other one is called as its simulator.
inline constexpr const char* kOwnBackend = "unietp";

/// Which data set was evaluated on.
struct EvaluatedDataset {
  std::string name;     // of its folder
  std::string version;  // of a frozen benchmark, "unietp-1.0"; "" for any other data set
  std::string digest;   // SHA-256 of what an agent acts in: tasks and homes (dataset_digest.h)
  int tasks = 0;        // that it has
  bool operator==(const EvaluatedDataset&) const = default;
};

/// A model that is asked in words, or a program or function that is given observations.
enum class AgentKind { Model, Policy };
/// As files name it: "model".
std::string_view name_of(AgentKind kind);

/// Who acted.
struct EvaluatedAgent {
  AgentKind kind = AgentKind::Model;
  std::string name;  // of the model as the server is asked for it; the policy as given: "noisy:0.1"
  std::map<std::string, std::string> files = {};  // of a policy that is not the program's: agent_files.h
  bool operator==(const EvaluatedAgent&) const = default;
};

/// How a model is told of an episode, and asked.
struct TalkSettings {
  std::string prompt = "unietp";  // name of the prompt
  std::string prompt_digest;      // SHA-256 of its file
  int history = -1;               // turns that are told again; -1: all
  int images = 1;                 // pictures sent: the present one and so many before it less one; 0: none
  bool multi = false;             // one turn of the chat for each step; else everything in one
  bool described = false;         // what is in view is told in words in the place of a picture
  bool thinking = false;          // the prompt asks for a rationale before the action
  bool structured = false;        // the server is asked to keep to a JSON schema
  bool operator==(const TalkSettings&) const = default;
};

/// What the server is asked to sample by; what is not set is left to it.
struct SamplingSettings {
  std::optional<double> temperature, top_p;
  std::optional<int> max_tokens;
  std::optional<std::uint64_t> seed;  // of the first repeat; each further one adds 1
  std::string extra = "{}";           // further fields of the body: a JSON object as compact text
  bool operator==(const SamplingSettings&) const = default;
};

/// Which episodes: in the order of the data set, each task in every mode, each as often as `repeats`.
struct EpisodeSelection {
  std::vector<Mode> modes{Mode::M1};
  std::vector<std::string> splits, simulators, tasks;  // empty: all
  int limit = 0;                                       // most tasks; 0: all
  int repeats = 1;
  std::uint64_t seed = 0;  // of policies that draw
  bool operator==(const EpisodeSelection&) const = default;
};

/// Everything that shapes the results. A run is only resumed with an equal one.
struct EvaluationSetup {
  std::string program_version, program_build;  // core/version.h
  std::string program_digest;                  // SHA-256 of the program's file; "" in runs that do not tell
  std::string knowledge_digest;                // of tables, profiles, layouts and templates
  std::string backend = kOwnBackend;           // whose physics and pictures
  EvaluatedDataset dataset;
  EvaluatedAgent agent;
  EpisodeSelection selection;
  std::map<Mode, Settings> settings;         // of each mode; "conventions" is the preset
  std::optional<TalkSettings> talk;          // of a model
  std::optional<SamplingSettings> sampling;  // of a model
  double price_in = 0, price_out = 0;        // of a million tokens, in any currency
  bool operator==(const EvaluationSetup&) const = default;
};

/// What came of it so far.
struct EvaluationTotals {
  int episodes = 0, finished = 0, errored = 0;  // asked for; ended by the agent or a limit; without a reply
  std::vector<std::string> models;              // that the server says it answered with; sorted, each once
  std::int64_t prompt_tokens = 0, completion_tokens = 0;
  double cost = 0;
  /// No episode is missing or errored.
  bool complete() const { return finished == episodes; }
  bool operator==(const EvaluationTotals&) const = default;
};

/// Episodes that a report has pictures of unless another number is asked for.
inline constexpr int kReportPictures = 40;

/// manifest.json in the folder of an evaluation.
struct EvaluationManifest {
  EvaluationSetup setup;
  EvaluationTotals totals;
  std::map<std::string, std::string> files;  // SHA-256 by name; without those that this run has not written yet
  int report_pictures = kReportPictures;     // most episodes that the report has pictures of
  bool operator==(const EvaluationManifest&) const = default;
};

/// The text of the file. Equal manifests give equal bytes.
std::string to_text(const EvaluationManifest& manifest);
/// Errors: Parse with line and column; Schema with a JSON pointer.
Result<EvaluationManifest> read_evaluation_manifest(std::string_view where, std::string_view text);

/// What differs between two setups, one line each: `settings.M1.steps: 50 then, 60 now`. Empty when they are equal.
std::vector<std::string> differences(const EvaluationSetup& then, const EvaluationSetup& now);

}  // namespace unietp
