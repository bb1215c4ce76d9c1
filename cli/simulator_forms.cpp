#include "cli/simulator_forms.h"

#include <memory>
#include <utility>

#include "exports/express.h"
#include "scene/telling_order.h"

namespace unietp {
namespace {

/// The forms, with the request that they refer to.
struct Forms {
  ExportRequest request;
  FormCheck check;
};

Result<std::shared_ptr<const Forms>> read_forms(const Resources& resources, const DataFolders& folders) {
  auto forms = std::make_shared<Forms>();
  forms->request.data = folders.root / "data";
  for (const Backend& backend : resources.backends)
    forms->request.backends.push_back({&backend.knowledge, &backend.profile});
  auto check = form_check(forms->request);
  if (!check) return check.error();
  forms->check = std::move(*check);
  return std::shared_ptr<const Forms>(std::move(forms));
}

/// A task as it is read from a data set, as far as its forms ask.
FinishedTask finished(const Task& task) {
  FinishedTask made;
  TaskRecord& record = made.record;
  const Specification& specification = task.episode.specification;
  record.id = task.id;
  record.template_name = specification.template_name;
  record.split = name_of(specification.split);
  record.simulator = name_of(specification.simulator);
  record.scene = task.episode.start.id;
  record.layout = task.episode.layout;
  record.goal_text = to_text(specification.goal);
  record.goal_tree = specification.goal;
  record.changes = task.episode.changes;
  record.instruction = task.instruction.text;
  DemonstrationRecord& shown = made.shown[Mode::M1];
  shown.task = task.id;
  shown.mode = name_of(Mode::M1);
  for (const DemonstrationStep& step : task.demonstration.steps)
    shown.steps.push_back({step.command, step.outcome.success, std::string(name_of(step.outcome.failure)),
                           step.outcome.feedback, step.visible, step.changes, step.moments, step.search, step.tidying});
  made.start = in_telling_order(task.episode.start);
  return made;
}

}  // namespace

Result<SimulatorCheck> simulator_check(const Resources& resources, const DataFolders& folders) {
  auto forms = read_forms(resources, folders);
  if (!forms) return forms.error();
  return SimulatorCheck([forms = std::move(*forms), &resources](const Task& task) -> SimulatorSupport {
    const FinishedTask made = finished(task);
    FormSupport support = forms->check(made);
    auto refused = refused_in_simulator(made, support, resources.backend(made.start.simulator).knowledge);
    return {std::move(support.express), std::move(refused)};
  });
}

Result<FormsOf> forms_of_tasks(const Resources& resources, const DataFolders& folders) {
  auto forms = read_forms(resources, folders);
  if (!forms) return forms.error();
  return FormsOf([forms = std::move(*forms)](FinishedTask task) {
    task.start = in_telling_order(task.start);
    return forms->check(task).express;
  });
}

}  // namespace unietp
