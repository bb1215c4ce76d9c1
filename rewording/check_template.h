#pragma once

#include <vector>

#include "logic/formula.h"
#include "record/manifest_record.h"
#include "record/task_record.h"
#include "resources/resources.h"
#include "validator/problem.h"

namespace unietp {

/// A task held against its template, for the validator: the template is of the task's split and simulator, the binding
/// is of its placeholders and meets its constraints, and goal, start constraints, purpose, style and refinement are
/// those that the template gives with it. Of a task that was refined, the goal without the refinement is compared; its
/// start has constraints of its own. `goal`: of the task, read. A template that `resources` lacks is a problem, unless
/// the manifest records it as one of the user's own. Pure.
std::vector<Problem> check_template(const TaskRecord& task, const Formula& goal, const ManifestRecord& manifest,
                                    const Resources& resources);

}  // namespace unietp
