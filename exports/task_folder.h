#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "exports/finished_tasks.h"

namespace unietp {

/// How many tasks the format could say, and how many it could not.
struct ExportedTasks {
  std::size_t said = 0, left_out = 0;
};

/// Says a task in files below `folder`. What it gives back is why the format does not say the task; nothing when it
/// does.
using SayTask =
    std::function<Result<std::optional<std::string>>(const FinishedTask&, const std::filesystem::path& folder)>;

/// Writes a data set in a format that says a task at a time, and `left_out.jsonl` with each task that it does not say
/// and why. `modes`: whose demonstrations are wanted. `finish` writes what belongs to all tasks together. `out` must
/// not exist; it appears as a whole at the end. Errors: those of reading the data set, of `say` and `finish`, Io, Usage
/// for a folder that is there.
Result<ExportedTasks> write_task_folder(
    const std::filesystem::path& dataset, const std::vector<Mode>& modes, const std::filesystem::path& out,
    const SayTask& say, const std::function<Result<Done>(const std::filesystem::path& folder)>& finish = nullptr);

/// "12 tasks in out/pddl, 3 left out"
std::string summary_of(const ExportedTasks& made, const std::filesystem::path& out);

}  // namespace unietp
