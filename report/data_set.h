#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/result.h"
#include "record/task_record.h"
#include "record/trait_table.h"
#include "scene/scene.h"

namespace unietp {

/// What is known of a finished data set's folder before its tasks are read, which is done one at a time
/// (record/dataset_reader.h). Its size does not depend on the number of tasks.
struct FinishedSet {
  std::filesystem::path folder;
  std::string name;         // of the folder, for people
  std::string digest;       // SHA-256 of tasks.jsonl
  TraitCounts level;        // "receptacle" → "ai2thor/Sofa" → tasks that have it
  std::vector<Mode> modes;  // that it has demonstrations of
};

/// Errors: Usage, when this is no folder; Io.
Result<FinishedSet> read_finished_set(const std::filesystem::path& folder);

/// The start scene of a task. Errors: Io, Parse, Schema.
Result<Scene> read_start_scene(const std::filesystem::path& folder, const TaskRecord& task);

/// What a command reports that reads a data set twice and finds other tasks the second time.
Error changed_while_read(const FinishedSet& set);

}  // namespace unietp
