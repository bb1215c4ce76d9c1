#pragma once

#include <vector>

#include "logic/formula.h"
#include "record/task_record.h"
#include "resources/resources.h"
#include "validator/problem.h"

namespace unietp {

/// A task's recorded grade and its reasons against those that its goal is graded with now, for the validator. Pure.
std::vector<Problem> check_sense(const TaskRecord& task, const Formula& goal, const Resources& resources);

}  // namespace unietp
