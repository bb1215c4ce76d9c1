#include "exports/bddl_files.h"

#include "core/files.h"
#include "exports/bddl.h"

namespace unietp {

Result<ExportedTasks> export_bddl(const std::filesystem::path& dataset, const std::vector<ValidationBackend>& backends,
                                  const std::filesystem::path& synsets, const std::filesystem::path& out) {
  const auto table = read_bddl_synsets(synsets);
  if (!table) return table.error();
  const auto say = [&](const FinishedTask& task,
                       const std::filesystem::path& folder) -> Result<std::optional<std::string>> {
    const auto& knowledge = *backend_of(backends, task.start).knowledge;
    const auto problem = bddl_problem(task.record.id, task.record.goal_tree, task.start, knowledge, *table);
    if (!problem) return std::optional(problem.error().message);
    const std::string text = "; " + task.record.instruction + "\n; " + task.record.goal_text + "\n" + *problem;
    if (auto written = write_file(folder / (task.record.id + ".bddl"), text); !written) return written.error();
    return std::optional<std::string>();
  };
  return write_task_folder(dataset, {}, out, say);
}

}  // namespace unietp
