#include "exports/bddl_files.h"

#include "core/files.h"
#include "exports/bddl.h"
#include "exports/finished_tasks.h"
#include "exports/left_out.h"
#include "exports/whole_folder.h"

namespace unietp {

Result<BddlExport> export_bddl(const std::filesystem::path& dataset, const std::vector<ValidationBackend>& backends,
                               const std::filesystem::path& synsets, const std::filesystem::path& out) {
  const auto table = read_bddl_synsets(synsets);
  if (!table) return table.error();
  BddlExport made;
  const auto written = write_whole_folder(out, [&](const std::filesystem::path& aside) -> Result<Done> {
    auto tasks = FinishedTasks::open(dataset, {});
    if (!tasks) return tasks.error();
    std::string left_out;
    while (const auto lines = tasks->next()) {
      const auto task = tasks->read(*lines);
      if (!task) return task.error();
      const auto& knowledge = *backend_of(backends, task->start).knowledge;
      const auto problem = bddl_problem(task->record.id, task->record.goal_tree, task->start, knowledge, *table);
      if (!problem) {
        left_out += left_out_line(task->record, problem.error().message);
        ++made.left_out;
        continue;
      }
      ++made.problems;
      const std::string text = "; " + task->record.instruction + "\n; " + task->record.goal_text + "\n" + *problem;
      if (auto ok = write_file(aside / (task->record.id + ".bddl"), text); !ok) return ok;
    }
    return write_file(aside / "left_out.jsonl", left_out);
  });
  if (!written) return written.error();
  return made;
}

}  // namespace unietp
