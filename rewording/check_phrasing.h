#pragma once

#include <vector>

#include "record/task_record.h"
#include "resources/resources.h"
#include "validator/problem.h"

namespace unietp {

/// A text that is recorded as a phrasing of its template's `(instruction …)`: the template has it, the grammar wrote
/// the text, and the words of the phrasing outside of its slots come in the text in their order. A template that
/// `resources` lacks says nothing. Pure.
std::vector<Problem> check_phrasing(const TaskRecord& task, const Resources& resources);

}  // namespace unietp
