#pragma once

#include <string>
#include <vector>

#include "core/error.h"
#include "scene/scene.h"
#include "validator/task_record.h"
#include "validator/validate.h"

namespace unietp {

/// Where a task, its scene and one of its demonstrations came from, for messages ("tasks.jsonl:3").
struct TaskFiles {
  std::string task, scene, demonstration;
};
/// Proves one task in fresh physics, but for its demonstrations; empty when it stands.
std::vector<Error> prove_task(const TaskRecord& task, const Scene& start, const ValidationBackend& backend,
                              const ValidationOptions& options, const TaskFiles& files);
/// Proves one demonstration of it in fresh physics, under the rules of its mode.
std::vector<Error> prove_demonstration(const TaskRecord& task, const Scene& start, Mode mode,
                                       const DemonstrationRecord& demonstration, const ValidationBackend& backend,
                                       const TaskFiles& files);

}  // namespace unietp
