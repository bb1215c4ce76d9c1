#pragma once

#include <map>
#include <string>
#include <vector>

#include "validator/folder_reading.h"
#include "validator/problem.h"
#include "validator/task_facts.h"

namespace unietp {

/// What the tasks count as when a data set is kept level: by dimension, how many tasks have each value.
using ValueCounts = std::map<std::string, std::map<std::string, int>>;

struct DatabaseCheck {
  ValueCounts traits;
  std::vector<Problem> problems;
};

/// dataset.sqlite against the other files: the same tasks with the same fields, their bindings, as many steps as they
/// count, as many rejections; and the traits of each task, which are its template, its home, the rooms where what is
/// handled stands, and otherwise categories that it binds. All tasks of the set read; `facts` are in their order.
DatabaseCheck check_database(const FolderReading& set, const std::vector<TaskFacts>& facts);

}  // namespace unietp
