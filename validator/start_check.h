#pragma once

#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "record/task_record.h"
#include "scene/scene.h"
#include "validator/problem.h"

namespace unietp {

/// What is wrong with the changes that make a start of a home, apart from physics. They are the shortest ones, in their
/// order. A changed object is what it was, but for where it lies, its states, its size and its color or material. A new
/// one is as the knowledge base says: its archetype, its states, its mass in proportion to its size. And the edits name
/// what was added, removed and changed.
std::vector<Problem> check_start(const TaskRecord& task, const Scene& home, const Scene& start,
                                 const Knowledge& knowledge, const std::string& where);

}  // namespace unietp
