#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "exports/finished_tasks.h"
#include "exports/formats.h"

namespace unietp {

/// How many tasks the format could say, and how many it could not.
struct ExportedTasks {
  std::size_t said = 0, left_out = 0;
  std::map<std::string, std::size_t> reasons;  // why those were left out, without the numbers of objects: how many
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

/// "the support bowl" for "the support bowl_12", so that reasons can be counted.
std::string without_numbers(const std::string& reason);
/// A line for each reason, the most frequent first: "\n  3: the support bowl is fixed".
std::string reason_lines(const std::map<std::string, std::size_t>& reasons);
/// The same: [{"reason": ..., "tasks": 3}].
nlohmann::ordered_json reasons_json(const std::map<std::string, std::size_t>& reasons);

/// "12 tasks in out/pddl, 3 left out" and the reasons.
ExportSummary summary_of(const ExportedTasks& made, const std::filesystem::path& out);

}  // namespace unietp
