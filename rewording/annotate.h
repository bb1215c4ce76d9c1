#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "annotator/llm_writer.h"
#include "resources/resources.h"
#include "rewording/paired_wordings.h"

namespace unietp {

/// Who writes: the grammar, a language model that is asked now, or the answers that a model gave to a batch of
/// requests.
enum class Writer { Grammar, Llm, Batch };
/// "grammar", as on the command line.
std::string_view name_of(Writer writer);
std::optional<Writer> writer_named(std::string_view name);

/// How the instructions of a finished data set are written anew.
struct AnnotateOptions {
  Writer writer = Writer::Grammar;
  std::optional<std::uint64_t> seed;  // of the wording; without it each run's own, which gives the texts it had
  std::optional<English> english;     // without it that of the data set
  bool paired = false;                // also write wordings.jsonl (paired_wordings.h); an older one goes otherwise
  bool contrasts = false;             // with contrasts in it
  std::size_t wordings = 2;           // different texts of each task's goal in it, as far as there are so many
  bool replace_human = false;         // also texts that people wrote or corrected
  bool stand_in = false;              // the grammar's texts stand in where no answer came
  LlmWriterOptions llm;               // its phrasings are the grammar's, too; the rest is for the other two writers
};

/// What was written.
struct AnnotateReport {
  int tasks = 0;
  std::map<std::string, int> by_writer;
  /// Why the grammar wrote in place of the model, for how many tasks, and the first of them.
  struct StandIns {
    int tasks = 0;
    std::string first;
  };
  std::map<std::string, StandIns> stand_ins;
  int by_people = 0;      // texts that were kept
  int unanswered = 0;     // requests to the model
  std::string no_answer;  // why the first of them has none
  PairCounts pairs;       // in wordings.jsonl
  bool written = false;   // false: an answer is missing, so that everything is as it was
};

/// Writes the instructions of the data set in `folder` anew, to `out` (which may be `folder`: it is replaced at once,
/// when all is written). Starts, goals, demonstrations and rejections stay, and so do texts by people; tasks.jsonl,
/// dataset.sqlite and the manifest follow. Two tasks of one home keep different texts. Unless all requests were
/// answered, or the grammar may stand in, nothing is written. Deterministic for the grammar, and for a model in its
/// answers. Errors: Io; Parse, Schema of a file; Usage, also when another process works on the folder; Unsatisfiable,
/// when a goal has no words (names the task). Then, too, nothing is written. Some hundred tasks are in memory at a
/// time, and of all others the texts of homes that have tasks to come.
Result<AnnotateReport> annotate_dataset(const std::filesystem::path& folder, const std::filesystem::path& out,
                                        const Resources& resources, const AnnotateOptions& options);

/// Calls `use` with the requests of a model's first round, some tasks at a time. Errors: as above.
Result<Done> prompts_for(const std::filesystem::path& folder, const Resources& resources,
                         const AnnotateOptions& options,
                         const std::function<void(const std::vector<LlmRequest>&)>& use);

}  // namespace unietp
