#include "cli/full_validation.h"

#include <memory>

#include "cli/simulator_forms.h"
#include "dataset/configuration.h"
#include "dataset/configuration_json.h"
#include "record/dataset_lines.h"
#include "record/text_writer.h"
#include "resources/own_phrasings.h"
#include "rewording/check_phrasing.h"
#include "rewording/check_sense.h"
#include "rewording/check_template.h"
#include "rewording/check_text.h"
#include "rewording/expected_files.h"
#include "rewording/grammar_text.h"
#include "rewording/paired_wordings.h"
#include "run/homes_of_slots.h"
#include "run/known_homes.h"
#include "run/make_home.h"
#include "run/remake_task.h"
#include "validator/lazy_values.h"

namespace unietp {
namespace {

/// How the grammar wrote the texts that `annotate` wrote.
GrammarWording wording_of(const RecordedWriting& writing) {
  return {phrasings_named(writing.phrasings).value_or(Phrasings::Everyday), recorded_english(writing.english),
          writing.seed};
}

using PlannedHomes = LazyValues<Result<HomesOfSlots>>;  // by the text of the configuration

/// Whether a home is of the block of a slot. Which block that is cannot be told of given homes, or where
/// templates of the user's own are not known here.
std::string home_fault(int slot, const std::string& home, const ManifestRecord& manifest, const Resources& resources,
                       PlannedHomes& planned) {
  const auto configuration = configuration_from_json(kManifest, manifest.run.text);
  if (!configuration || !configuration->scenes.empty()) return "";  // the former is told elsewhere
  for (const std::string& own : configuration->own)
    if (!is_known_template(resources, own.substr(0, own.find(' ')))) return "";
  const auto homes = planned.get(manifest.run.text, [&] { return HomesOfSlots::of(*configuration, resources); });
  if (!*homes) return "is of a run that cannot be planned again: " + homes->error().message;
  if ((*homes)->may_fill(slot, home)) return "";
  return "is in " + home + ", where the run does not fill slot " + std::to_string(slot);
}

Result<Instruction> rewritten(const TaskRecord& record, const Scene& start, const RecordedWriting& writing,
                              const Resources& resources) {
  const auto task = worded_task({}, 0, record);
  return task ? text_again(*task, start, resources, wording_of(writing)) : Result<Instruction>(task.error());
}

Result<std::optional<WordingsRecord>> wordings_again(const TaskRecord& record, const Scene& start,
                                                     const DemonstrationRecord& in_m1, const RecordedWriting& writing,
                                                     const Resources& resources) {
  if (!is_known_template(resources, record.template_name)) return std::optional<WordingsRecord>();
  const auto task = worded_task({}, 0, record);
  if (!task) return task.error();
  const auto wording = wording_of(writing);
  const auto pair = paired_wordings(*task, start, in_m1, resources,
                                    {wording.phrasings, wording.english, wording.seed, writing.pairs->contrasts,
                                     static_cast<std::size_t>(writing.pairs->wordings)});
  if (!pair) return pair.error();
  auto read = read_wordings(kWordingsFile, 1, line_of(*pair));
  if (!read) return read.error();
  return std::optional(std::move(*read));
}

}  // namespace

Result<ValidationOptions> full_validation(const Resources& resources, const DataFolders& folders) {
  ValidationOptions options;
  options.check_text = [&resources](const StatedGoal& stated) {
    return check_text(stated, resources.backend(stated.simulator));
  };
  options.home_in_run = [&resources, planned = std::make_shared<PlannedHomes>()](int slot, const std::string& home,
                                                                                 const ManifestRecord& manifest) {
    return home_fault(slot, home, manifest, resources, *planned);
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
  options.remake_task = [&resources, tasks = std::make_shared<TaskRemaker>(resources)](
                            const TaskRecord& task, const Formula& goal, const std::vector<Formula>& constraints,
                            const std::shared_ptr<const Scene>& home,
                            const ManifestRecord& manifest) -> Result<RemadeTask> {
    const auto configuration = configuration_from_json(kManifest, manifest.run.text);
    if (!configuration) return configuration.error();
    auto made = tasks->make(*configuration, task, goal, constraints, home);
    if (!made) return made.error();
    const auto& writing = manifest.writing;
    const bool again = writing && text_writer_of(task.writer) == TextWriter::Grammar && !made->instruction.text.empty();
    const auto text = again ? rewritten(task, made->episode.start, *writing, resources)
                            : Result<Instruction>(std::move(made->instruction));
    if (!text) return text.error();
    return RemadeTask{std::move(made->episode.changes), std::move(made->episode.edits), text->text, text->phrasing};
  };
  options.remake_wordings = [&resources](const TaskRecord& task, const Scene& start, const DemonstrationRecord& in_m1,
                                         const ManifestRecord& manifest) {
    return wordings_again(task, start, in_m1, *manifest.writing, resources);
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
