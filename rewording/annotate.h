#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "annotator/llm_writer.h"
#include "resources/resources.h"

namespace unietp {

enum class Writer { Grammar, Llm, Batch };
std::string_view name_of(Writer writer);
std::optional<Writer> writer_named(std::string_view name);

/// How the instructions of a finished data set are written anew.
struct AnnotateOptions {
  Writer writer = Writer::Grammar;
  std::optional<std::uint64_t> seed;  // of the wording; without it each run's own, which gives the texts it had
  bool paired = false;                // also write wordings.jsonl (paired_wordings.h); an older one goes otherwise
  LlmWriterOptions llm;               // its phrasings are the grammar's, too; the rest is for the other two writers
};

struct AnnotateReport {
  int tasks = 0;
  std::map<std::string, int> by_writer;
  std::vector<std::pair<std::string, std::string>> stand_ins;  // task, why the grammar wrote in place of the model
};

/// Writes the instructions of the data set in `folder` anew, to `out` (which may be `folder`: it is replaced at once,
/// when all is written). Starts, goals, demonstrations and rejections stay; tasks.jsonl, dataset.sqlite and the
/// manifest follow. Two tasks of one home keep different texts. Deterministic for the grammar, and for a model in its
/// answers. Errors: Io; Parse, Schema of a file; Usage; Unsatisfiable, when a goal has no words (names the task).
Result<AnnotateReport> annotate_dataset(const std::filesystem::path& folder, const std::filesystem::path& out,
                                        const Resources& resources, const AnnotateOptions& options);

/// The requests of a model's first round. Errors: as above.
Result<std::vector<LlmRequest>> prompts_for(const std::filesystem::path& folder, const Resources& resources,
                                            const AnnotateOptions& options);

}  // namespace unietp
