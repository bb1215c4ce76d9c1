#include "core/files.h"
#include "exports/bddl.h"
#include "exports/formats.h"
#include "exports/task_folder.h"

namespace unietp {
namespace {

/// `<task>.bddl` for each task of BEHAVIOR that BDDL can express, and left_out.jsonl.
Result<std::string> write_bddl(const ExportRequest& request) {
  const auto synsets = read_bddl_synsets(request.data / "bddl" / "synsets.csv");
  if (!synsets) return synsets.error();
  const auto say = [&](const FinishedTask& task,
                       const std::filesystem::path& folder) -> Result<std::optional<std::string>> {
    const auto& knowledge = *backend_of(request.backends, task.start).knowledge;
    const auto problem = bddl_problem(task.record.id, task.record.goal_tree, task.start, knowledge, *synsets);
    if (!problem) return std::optional(problem.error().message);
    const std::string text = "; " + task.record.instruction + "\n; " + task.record.goal_text + "\n" + *problem;
    if (auto written = write_file(folder, task.record.id + ".bddl", text); !written) return written.error();
    return std::optional<std::string>();
  };
  const auto made = write_task_folder(request.dataset, {}, request.out, say);
  if (!made) return made.error();
  return summary_of(*made, request.out);
}

}  // namespace

ExportFormat bddl_format() { return {"bddl", "BEHAVIOR tasks as BDDL problem files", {}, true, write_bddl}; }

}  // namespace unietp
