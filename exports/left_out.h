#pragma once

#include <string>

#include "validator/task_record.h"

namespace unietp {

/// A line of left_out.jsonl: a task that a format does not say, and why.
std::string left_out_line(const TaskRecord& task, const std::string& why);

}  // namespace unietp
