#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>

#include "annotator/phrasing_sets.h"
#include "core/result.h"
#include "dataset/lines.h"
#include "record/task_record.h"
#include "resources/resources.h"
#include "rewording/worded_task.h"
#include "scene/scene.h"

namespace unietp {

/// How paired wordings are written.
struct PairOptions {
  Phrasings phrasings = Phrasings::Everyday;
  English english = English::Us;
  std::optional<std::uint64_t> seed;  // of the wording; without it each run's own
  bool contrasts = false;             // also one word changed, another goal
  std::size_t wordings = 2;           // different texts that mean the task's goal, as far as the grammar has them
};

/// A task's line of wordings.jsonl: the same episode in a direct, a referring and a complex wording, marked as a pair
/// by the task's id, so that results compare like with like. Direct and complex state the task's goal; referring states
/// it of the object that the demonstration used, with that goal beside it, and is left out where nothing simple tells
/// the object apart. A contrast differs from the direct wording in one word and states another goal, which stands
/// beside it (minimal_pair.h). Further texts of the task's goal, plain ones first, fill up to `wordings` of them where
/// the grammar has so many for it. All are the grammar's and pass its checks. `demonstration`: in M1. Deterministic.
/// Errors: Unsatisfiable, where the goal has no words.
Result<WordingsEntry> paired_wordings(const WordedTask& task, const Scene& start,
                                      const DemonstrationRecord& demonstration, const Resources& resources,
                                      const PairOptions& options);

/// What was written.
struct PairCounts {
  std::map<std::size_t, int> tasks_by_wordings;  // tasks that have so many different texts of their own goal
  int referring = 0, contrasts = 0;
};

/// Writes `wordings.jsonl` to `file`: such a line for each task of a folder. Errors: Io, Parse, Schema of a file;
/// Unsatisfiable (names the task).
Result<PairCounts> write_paired_wordings(const std::filesystem::path& folder, const Resources& resources,
                                         const PairOptions& options, const std::filesystem::path& file);

}  // namespace unietp
