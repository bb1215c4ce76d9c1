#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/result.h"
#include "generator/specification.h"
#include "record/home_shelf.h"
#include "scene/trace.h"

namespace unietp {

/// A line of tasks.jsonl: the text as it stands, and what its instruction is made from.
struct TaskLine {
  std::string text;
  Specification specification;
  std::string id, scene, layout;
  Delta changes;           // of the home, which make the start
  std::uint64_t seed = 0;  // of the run
  int slot = 0, attempt = 0;
};

/// All tasks of a data set's folder, in order. Errors: Io; Parse and Schema with file and line.
Result<std::vector<TaskLine>> read_task_lines(const std::filesystem::path& folder);

/// The start scene of a task of the folder whose homes these are. Errors: those of HomeShelf::start.
Result<Scene> read_start(HomeShelf& homes, const TaskLine& task);

}  // namespace unietp
