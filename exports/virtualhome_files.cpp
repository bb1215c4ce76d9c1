#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/text.h"
#include "exports/formats.h"
#include "exports/task_folder.h"
#include "exports/virtualhome_program.h"
#include "interchange/formats.h"

namespace unietp {
namespace {

/// For each task of VirtualHome `<task>.json`, its start as an environment graph, `<task>.txt`, the demonstration in M1
/// as a program, and `<task>.names.json`, our ids with the numbers of their nodes; and left_out.jsonl.
Result<std::string> write_virtualhome_files(const ExportRequest& request) {
  const auto [facts, wrong] = read_format_facts(request.data / "scene_files");
  if (!wrong.empty()) return wrong.front();
  const auto say = [&, &facts = facts](const FinishedTask& task,
                                       const std::filesystem::path& folder) -> Result<std::optional<std::string>> {
    if (task.start.simulator != Simulator::Virtualhome) return std::optional<std::string>("not a task of VirtualHome");
    const auto graph = write_virtualhome(task.start, *backend_of(request.backends, task.start).knowledge, facts);
    if (!graph) return graph.error();
    const auto program = virtualhome_program(task.shown.at(Mode::M1), task.start, graph->names);
    if (!program) return std::optional(program.error().message);
    const TaskRecord& record = task.record;
    const std::string text = record.template_name + "\n" + record.instruction + "\n\n\n" + join(*program, "\n") + "\n";
    const nlohmann::ordered_json names(graph->names);
    for (const auto& [ending, content] :
         {std::pair{".json", graph->text}, {".txt", text}, {".names.json", names.dump(1) + "\n"}}) {
      if (auto written = write_file(folder, record.id + ending, content); !written) return written.error();
    }
    return std::optional<std::string>();
  };
  const auto made = write_task_folder(request.dataset, {Mode::M1}, request.out, say);
  if (!made) return made.error();
  return summary_of(*made, request.out);
}

}  // namespace

ExportFormat virtualhome_format() {
  return {
      "virtualhome",         "VirtualHome's environment graphs and programs", {}, true, write_virtualhome_files, true,
      Simulator::Virtualhome};
}

}  // namespace unietp
