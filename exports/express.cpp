#include "exports/express.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/files.h"
#include "exports/task_folder.h"
#include "interchange/own_ids.h"

namespace unietp {
namespace {

/// The first object handled of which the simulator has nothing; nullptr when there is none.
const Node* unknown_to_simulator(const FinishedTask& task, const Knowledge& knowledge) {
  std::vector<std::string> handled = task.start.agent.held;
  for (const StepRecord& step : task.shown.at(Mode::M1).steps) {
    for (const Argument& argument : step.command.args) handled.push_back(argument.id);
  }
  for (const std::string& id : handled) {
    const Node* const node = find_node(task.start, id);
    if (node == nullptr || own_id_of(*node, task.start.simulator)) continue;  // a room or a piece; the simulator's own
    if (knowledge.asset_rows_of(node->category).empty()) return node;
  }
  return nullptr;
}

}  // namespace

Result<std::string> write_expressed(const ExportRequest& request, const Result<ExpressTask>& express) {
  if (!express) return express.error();
  const auto say = [&](const FinishedTask& task,
                       const std::filesystem::path& folder) -> Result<std::optional<std::string>> {
    const auto expressed = (*express)(task);
    if (!expressed) return expressed.error();
    if (!expressed->refused.empty()) return std::optional(expressed->refused);
    for (const AssetFile& file : expressed->files) {
      if (auto written = write_file(folder, file.path, file.content); !written) return written.error();
    }
    return std::optional<std::string>();
  };
  const auto made = write_task_folder(request.dataset, {Mode::M1}, request.out, say);
  if (!made) return made.error();
  return summary_of(*made, request.out);
}

Result<NativeCheck> native_check(const ExportRequest& request) {
  std::array<ExpressTask, kSimulators.size()> forms;  // but Habitat's, which is written for all tasks together
  const std::array makers{std::pair{Simulator::Ai2thor, &express_ai2thor},
                          std::pair{Simulator::Virtualhome, &express_virtualhome_unity},
                          std::pair{Simulator::Behavior, &express_behavior}};
  for (const auto& [simulator, maker] : makers) {
    auto form = maker(request);
    if (!form) return form.error();
    forms[static_cast<std::size_t>(simulator)] = std::move(*form);
  }
  return NativeCheck([forms = std::move(forms), &request](const FinishedTask& task) -> Result<std::string> {
    const Knowledge& knowledge = *backend_of(request.backends, task.start).knowledge;
    if (const Node* const node = unknown_to_simulator(task, knowledge))
      return node->id + ": the simulator has no model of " + node->category;
    const ExpressTask& express = forms[static_cast<std::size_t>(task.start.simulator)];
    if (!express) return refused_by_habitat(task);
    auto expressed = express(task);
    if (!expressed) return expressed.error();
    return std::move(expressed->refused);
  });
}

}  // namespace unietp
