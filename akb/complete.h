#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "akb/complete_answer.h"
#include "akb/complete_request.h"
#include "llm/ask.h"
#include "llm/cache.h"

namespace unietp {

/// What a language model is asked to add to the tables, and how.
struct CompletionOptions {
  std::vector<Simulator> simulators;
  std::vector<FactKind> facts;
  std::vector<std::filesystem::path> overrides;  // the user's own, which state facts too
  int batch = 8;                                 // categories a request, >= 1
  std::optional<int> limit;  // categories to ask of the endpoint; those that the cache can answer do not count
  double confidence = kLeastConfidence;
  std::filesystem::path wordnet = "/usr/share/wordnet";  // synsets are not looked up when it is not there
  std::optional<double> temperature;
  std::optional<int> max_tokens;
  LlmOptions ask;
};

/// What is to be asked, before anything is sent.
struct CompletionPlan {
  struct Base {
    Simulator simulator = Simulator::Ai2thor;
    Tables tables;  // without completed facts
    CompletedFacts completed;
  };
  std::vector<Base> bases;
  std::vector<LlmRequest> requests;
  std::vector<CompletionBatch> batches;  // of each request
  std::vector<std::size_t> base_of;      // of each request: its place in `bases`
  std::map<FactKind, int> lacking;       // categories without such a fact from another source than a language model
  std::map<FactKind, int> completed;     // those of them that have one from a language model
};

/// Reads `<tables>/<simulator>` and what was completed before, and plans what is left. Deterministic. All problems of
/// the tables are appended to `errors`.
CompletionPlan plan_completion(const std::filesystem::path& tables, const LlmEndpoint& endpoint,
                               const CompletionOptions& options, LlmCache* cache, std::vector<Error>& errors);

/// What a completion did.
struct CompletionReport {
  LlmTotals totals;
  std::map<FactKind, int> accepted;  // facts that were added
  int unused = 0;                    // completed facts that do not count: another source states it, or it is ambiguous
  std::vector<RejectedFact> rejected;   // in the order of the requests
  std::map<std::string, int> failures;  // requests without an answer, by reason
  bool stopped = false;
};

/// Asks, checks every answer (check_completion) and writes `<tables>/completed/<simulator>/*.csv` after each, with the
/// source `llm:<model>`. A category that has a completed fact of a kind keeps it. The files are the same whatever the
/// order of arrival, and after a kill and a second run with the same cache. Errors: Usage (a model's name that cannot
/// be a source), Io (the files cannot be written).
Result<CompletionReport> complete_knowledge(const std::filesystem::path& tables, const LlmEndpoint& endpoint,
                                            const CompletionOptions& options, LlmCache* cache, CompletionPlan plan);

}  // namespace unietp
