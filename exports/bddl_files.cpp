#include "core/files.h"
#include "exports/bddl.h"
#include "exports/formats.h"
#include "exports/task_folder.h"

namespace unietp {
namespace {

/// `<task>.bddl` for each task of BEHAVIOR that BDDL can express, and left_out.jsonl.
Result<ExportSummary> write_bddl(const ExportRequest& request) {
  const auto words = read_bddl_words(request.data / "bddl");
  if (!words) return words.error();
  const auto say = [&](const FinishedTask& task,
                       const std::filesystem::path& folder) -> Result<std::optional<std::string>> {
    const auto& knowledge = *backend_of(request.backends, task.start).knowledge;
    const auto problem = bddl_problem(task, knowledge, *words);
    if (!problem) return std::optional(problem.error().message);
    if (!problem->decides) return std::optional<std::string>("BDDL evaluates only the last state");
    const std::string text = "; " + task.record.instruction + "\n; " + task.record.goal_text + "\n" + problem->text;
    if (auto written = write_file(folder, task.record.id + ".bddl", text); !written) return written.error();
    return std::optional<std::string>();
  };
  const auto made = write_task_folder(request.dataset, {Mode::M1}, request.out, say);
  if (!made) return made.error();
  return summary_of(*made, request.out);
}

}  // namespace

ExportFormat bddl_format() {
  return {"bddl", "BEHAVIOR tasks as BDDL problem files", {}, true, write_bddl, true, Simulator::Behavior};
}

}  // namespace unietp
