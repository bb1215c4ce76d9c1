#pragma once

#include <string>
#include <vector>

#include "core/error.h"
#include "scene/scene.h"
#include "validator/task_record.h"
#include "validator/validate.h"

namespace unietp {

/// Proves one task in fresh physics; empty when it stands. `task_file`, `scene_file` and `demonstration_file` name
/// where each came from in messages ("tasks.jsonl:3").
struct TaskFiles {
  std::string task, scene, demonstration;
};
std::vector<Error> prove_task(const TaskRecord& task, const Scene& start, const DemonstrationRecord& demonstration,
                              const ValidationBackend& backend, const ValidationOptions& options,
                              const TaskFiles& files);

}  // namespace unietp
