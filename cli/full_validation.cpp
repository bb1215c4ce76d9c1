#include "cli/full_validation.h"

#include <memory>

#include "cli/simulator_forms.h"
#include "dataset/configuration_json.h"
#include "rewording/check_phrasing.h"
#include "rewording/check_sense.h"
#include "rewording/check_template.h"
#include "rewording/check_text.h"
#include "rewording/expected_files.h"
#include "run/known_homes.h"
#include "run/make_home.h"
#include "run/remake_task.h"

namespace unietp {

Result<ValidationOptions> full_validation(const Resources& resources, const DataFolders& folders) {
  ValidationOptions options;
  options.check_text = [&resources](const StatedGoal& stated) {
    return check_text(stated, resources.backend(stated.simulator));
  };
  options.check_template = [&resources](const TaskRecord& task, const Formula& goal, const ManifestRecord& manifest) {
    auto problems = check_template(task, goal, manifest, resources);
    for (auto& problem : check_sense(task, goal, resources)) problems.push_back(std::move(problem));
    for (auto& problem : check_phrasing(task, resources)) problems.push_back(std::move(problem));
    return problems;
  };
  options.make_home = [&resources](const ManifestRecord& manifest, const std::string& name) {
    const auto configuration = configuration_from_json(kManifest, manifest.run.text);
    return configuration ? make_home(*configuration, resources, name) : Result<Scene>(configuration.error());
  };
  options.remake_task = [tasks = std::make_shared<TaskRemaker>(resources)](
                            const TaskRecord& task, const Formula& goal, const std::vector<Formula>& constraints,
                            const std::shared_ptr<const Scene>& home,
                            const ManifestRecord& manifest) -> Result<RemadeTask> {
    const auto configuration = configuration_from_json(kManifest, manifest.run.text);
    if (!configuration) return configuration.error();
    auto made = tasks->make(*configuration, task, goal, constraints, home);
    if (!made) return made.error();
    return RemadeTask{std::move(made->episode.changes), std::move(made->episode.edits), std::move(made->instruction)};
  };
  auto forms = forms_of_tasks(resources, folders);
  if (!forms) return forms.error();
  options.forms_of = std::move(*forms);
  options.derive_files = [&resources, licenses = folders.licenses()](const ManifestRecord& manifest) {
    return expected_files(manifest, resources, licenses);
  };
  auto known_homes = read_known_homes(folders.runs());
  if (!known_homes) return known_homes.error();
  options.known_homes = std::move(*known_homes);
  return options;
}

}  // namespace unietp
