#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "annotator/phrasing_sets.h"
#include "core/result.h"
#include "resources/resources.h"
#include "rewording/task_lines.h"

namespace unietp {

/// The text of `wordings.jsonl`: for each task of a folder the same episode in a direct, a referring and a complex
/// wording, marked as a pair by the task's id, so that results compare like with like. Direct and complex say the
/// task's goal; referring says it of the object that the demonstration used, with that goal beside it, and is left out
/// where nothing simple tells the object apart. `seed`: of the wording; without it each run's own. All are the
/// grammar's and pass its checks. Errors: Io, Parse, Schema of a file; Unsatisfiable (names the task).
Result<std::string> paired_wordings(const std::filesystem::path& folder, const std::vector<TaskLine>& lines,
                                    const Resources& resources, Phrasings phrasings, std::optional<std::uint64_t> seed);

}  // namespace unietp
