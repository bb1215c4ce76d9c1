#pragma once

#include <filesystem>
#include <vector>

#include "annotator/instruction.h"
#include "core/result.h"
#include "generator/specification.h"
#include "record/home_cache.h"
#include "record/task_record.h"

namespace unietp {

/// A task of a finished data set, and what its instruction is made from.
struct WordedTask {
  TaskRecord record;
  Specification specification;
};

/// All tasks of a data set's folder, in order. The demonstrations and wordings are read along, so that a folder whose
/// files do not belong together is refused before anything is written. Errors: Io; Parse and Schema with file and line.
Result<std::vector<WordedTask>> read_worded_tasks(const std::filesystem::path& folder);

/// The instruction that the task has.
Instruction instruction_of(const WordedTask& task);

/// The start scene of a task of the folder whose homes these are. Errors: those of HomeCache::start.
Result<Scene> read_start(HomeCache& homes, const WordedTask& task);

}  // namespace unietp
