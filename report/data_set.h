#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/result.h"
#include "record/task_record.h"
#include "record/trait_table.h"
#include "scene/scene.h"

namespace unietp {

/// A finished data set's folder but for what is large: scenes and demonstrations are read when they are asked for.
struct FinishedSet {
  std::filesystem::path folder;
  std::string name;                       // of the folder, for people
  std::string digest;                     // SHA-256 of tasks.jsonl
  std::vector<TaskRecord> tasks;          // in the order of the file
  std::vector<RejectionRecord> given_up;  // lines of rejections.jsonl
  TraitCounts level;                      // "receptacle" → "ai2thor/Sofa" → tasks that have it
  std::vector<Mode> modes;                // that it has demonstrations of
};

/// Errors: Io; Parse and Schema with file and line.
Result<FinishedSet> read_finished_set(const std::filesystem::path& folder);

/// The start scene of a task. Errors: Io, Parse, Schema.
Result<Scene> read_start_scene(const std::filesystem::path& folder, const TaskRecord& task);

/// The demonstrations of a mode, parsed with so many threads and handed to `use(i, demonstration)` task by task, in
/// their order. Errors: as above; Schema when they are not those of the tasks.
Result<Done> read_demonstrations(const FinishedSet& set, Mode mode, int threads,
                                 const std::function<void(std::size_t, const DemonstrationRecord&)>& use);

}  // namespace unietp
