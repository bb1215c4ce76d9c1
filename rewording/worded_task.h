#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "annotator/instruction.h"
#include "core/result.h"
#include "generator/specification.h"
#include "record/dataset_lines.h"
#include "record/home_cache.h"
#include "record/task_record.h"

namespace unietp {

/// A task of a finished data set, and what its instruction is made from.
struct WordedTask {
  TaskRecord record;
  Specification specification;
};

/// The task of line `line` of a data set's folder. Errors: Parse and Schema with file and line.
Result<WordedTask> worded_task(const std::filesystem::path& folder, int line, TaskRecord record);

/// All parts of a data set's folder that have a line for each task, start scenes apart: whoever reads them learns that
/// the files belong together.
DatasetParts all_lines(const std::filesystem::path& folder);

/// Calls `use` for each task of the folder, in order; one is in memory at a time. Stops at the first error of `use`.
/// `parts` are read along. Errors: Io; Parse and Schema with file and line; those of `use`.
Result<Done> for_each_worded_task(const std::filesystem::path& folder, const DatasetParts& parts,
                                  const std::function<Result<Done>(WordedTask&&)>& use);

/// The same, where the lines of all parts are only matched with their tasks, not parsed: whether the files belong
/// together is known in a third of the time. Errors: the same, but for what shows only in parsing a demonstration.
Result<Done> for_each_matched_task(const std::filesystem::path& folder,
                                   const std::function<Result<Done>(WordedTask&&)>& use);

/// The English that files record as "us" or "gb"; American for anything else.
English recorded_english(std::string_view name);

/// The instruction that the task has.
Instruction instruction_of(const WordedTask& task);

/// The start scene of a task of the folder whose homes these are. Errors: those of HomeCache::start.
Result<Scene> read_start(HomeCache& homes, const WordedTask& task);

}  // namespace unietp
