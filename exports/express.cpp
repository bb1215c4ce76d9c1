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

/// Why a form does not express a task; "" where it does.
std::string refusal_of(const ExpressTask& form, const FinishedTask& task) {
  auto expressed = form(task);
  return expressed ? expressed->refused : expressed.error().message;
}

}  // namespace

Result<ExpressTask> express_form(SimulatorForm::Kind form, const ExportRequest& request) {
  switch (form) {
    case SimulatorForm::Kind::Ai2thor:
      return express_ai2thor(request);
    case SimulatorForm::Kind::Virtualhome:
      return express_virtualhome(request);
    case SimulatorForm::Kind::VirtualhomeUnity:
      return express_virtualhome_unity(request);
    case SimulatorForm::Kind::Behavior:
      return express_behavior(request);
    case SimulatorForm::Kind::Habitat:
      break;
  }
  return ExpressTask([](const FinishedTask& task) -> Result<ExpressedTask> {
    return ExpressedTask{refused_by_habitat(task), nullptr};
  });
}

Result<ExportSummary> write_expressed(const ExportRequest& request, const Result<ExpressTask>& express) {
  if (!express) return express.error();
  const auto say = [&](const FinishedTask& task,
                       const std::filesystem::path& folder) -> Result<std::optional<std::string>> {
    const auto expressed = (*express)(task);
    if (!expressed) return expressed.error();
    if (!expressed->refused.empty()) return std::optional(expressed->refused);
    const auto files = expressed->files();
    if (!files) return files.error();
    for (const AssetFile& file : *files) {
      if (auto written = write_file(folder, file.path, file.content); !written) return written.error();
    }
    return std::optional<std::string>();
  };
  const auto made = write_task_folder(request.dataset, {Mode::M1}, request.out, say);
  if (!made) return made.error();
  return summary_of(*made, request.out);
}

Result<FormCheck> form_check(const ExportRequest& request) {
  std::array<ExpressTask, kSimulatorForms.size()> forms;
  for (std::size_t i = 0; i < forms.size(); ++i) {
    auto form = express_form(kSimulatorForms[i].kind, request);
    if (!form) return form.error();
    forms[i] = std::move(*form);
  }
  return FormCheck([forms = std::move(forms)](const FinishedTask& task) {
    FormSupport support;
    for (std::size_t i = forms.size(); i-- > 0;) {  // what the strictest expresses, the others do
      if (kSimulatorForms[i].simulator != task.start.simulator) continue;
      const bool expressed = !support.express.empty();
      auto refused = expressed ? std::string() : refusal_of(forms[i], task);
      if (refused.empty()) support.express.insert(support.express.begin(), std::string(kSimulatorForms[i].name));
      if (!refused.empty() && support.refused.empty()) support.refused = std::move(refused);
    }
    return support;
  });
}

std::string refused_in_simulator(const FinishedTask& task, const FormSupport& support, const Knowledge& knowledge) {
  if (const Node* const node = unknown_to_simulator(task, knowledge))
    return node->id + ": the simulator has no model of " + node->category;
  return support.refused;
}

}  // namespace unietp
