#include "rewording/written_again.h"

#include "dataset/configuration_json.h"
#include "record/dataset_lines.h"
#include "scene/scene_json.h"

namespace unietp {
namespace {

Result<Instruction> instruction_of(const WordingRecord& wording) {
  const auto style = style_named(wording.style);
  if (!style) return Error{Error::Kind::Schema, kWordingsFile, {}, "names an unknown style \"" + wording.style + "\""};
  return Instruction{wording.text, wording.writer, *style, wording.checks, wording.fallback};
}

}  // namespace

TaskEntry written_again(const TaskRecord& task, const Instruction& instruction) {
  TaskEntry entry;
  entry.id = task.id;
  entry.template_name = task.template_name;
  entry.split = task.split;
  entry.simulator = task.simulator;
  entry.scene = task.scene;
  entry.layout = task.layout;
  entry.bindings = task.bindings;
  entry.refinement = task.refinement;
  entry.goal_text = task.goal_text;
  entry.goal = task.goal_tree;
  entry.start_constraints = task.start_constraints;
  entry.edits = task.edits;
  entry.changes = delta_to_json(task.changes);
  entry.instruction = instruction;
  entry.purpose = {task.purpose, task.because};
  entry.sense.grade = grade_named(task.grade).value_or(Grade::Senseless);
  for (const auto& part : task.sense)
    entry.sense.parts.push_back({part.part, {grade_named(part.grade).value_or(Grade::Senseless), 0, {}, part.why}});
  entry.forms = task.forms;
  for (const auto& count : task.expert)
    entry.expert.push_back({count.mode, count.steps, count.failures, count.shortest});
  entry.run_seed = task.run;
  entry.slot = task.slot;
  entry.attempt = task.attempt;
  return entry;
}

WrittenTask written_again(const TaskRecord& task, const Instruction& instruction,
                          const std::map<Mode, DemonstrationRecord>& shown) {
  const TaskEntry entry = written_again(task, instruction);
  WrittenTask written;
  written.row = row_of(entry);
  written.line = line_of(entry);
  for (const auto& [mode, demonstration] : shown) {
    std::vector<StepEntry> steps;
    for (const StepRecord& step : demonstration.steps) {
      steps.push_back({step.command, step.success, step.failure, step.feedback, step.visible, step.changes,
                       step.moments, step.search, step.tidying});
      written.row.actions.push_back(action_row(mode, steps.back()));
    }
    written.shown.push_back(demonstration_line(task.id, mode, steps, {demonstration.shortest, demonstration.tempting}));
  }
  return written;
}

RejectionEntry written_again(const RejectionRecord& rejection) {
  return {rejection.slot,  rejection.attempt, rejection.template_name, rejection.simulator,
          rejection.split, rejection.stage,   rejection.reason,        rejection.detail};
}

Result<WordingsEntry> written_again(const WordingsRecord& wordings) {
  WordingsEntry entry;
  entry.task = wordings.task;
  for (const auto& [kind, wording] : wordings.wordings) {
    auto instruction = instruction_of(wording);
    if (!instruction) return instruction.error();
    switch (kind) {
      case WordingKind::Direct:
        entry.direct = std::move(*instruction);
        break;
      case WordingKind::Complex:
        entry.complex = std::move(*instruction);
        break;
      case WordingKind::Contrast:
        entry.contrast = std::move(*instruction);
        entry.contrast_goal = wording.goal;
        break;
      case WordingKind::Referring:
        entry.referring = std::move(*instruction);
        entry.referring_goal = wording.goal;
        break;
    }
  }
  for (const WordingRecord& wording : wordings.others) {
    auto instruction = instruction_of(wording);
    if (!instruction) return instruction.error();
    entry.others.push_back(std::move(*instruction));
  }
  return entry;
}

ReviewMarkEntry written_again(const ReviewMarkRecord& mark) {
  return {mark.task, std::string(name_of(mark.verdict)), mark.before, mark.comment};
}

std::optional<WritingEntry> written_again(const std::optional<RecordedWriting>& writing) {
  if (!writing) return std::nullopt;
  WritingEntry again{writing->writer, writing->seed, writing->phrasings, writing->english, writing->counts};
  if (const auto& pairs = writing->pairs) again.pairs = {static_cast<std::size_t>(pairs->wordings), pairs->contrasts};
  return again;
}

Result<Manifest> written_again(std::string_view where, const ManifestRecord& manifest) {
  const auto configuration = configuration_from_json(where, manifest.run.text);
  if (!configuration) return configuration.error();
  Manifest again;
  again.version = manifest.program_version;
  again.knowledge_digest = manifest.knowledge_digest;
  again.benchmark = manifest.benchmark;
  again.configuration = *configuration;
  again.counts.tasks = manifest.tasks;
  again.counts.by_split = manifest.by_split;
  again.counts.by_simulator = manifest.by_simulator;
  again.counts.by_template = manifest.by_template;
  again.counts.by_sense = manifest.by_sense;
  again.counts.by_form = manifest.by_form;
  again.counts.not_usual = manifest.not_usual;
  again.counts.rejections = manifest.rejections;
  for (const auto& spread : manifest.balance) {
    const auto dimension = dimension_named(spread.dimension);
    if (!dimension)
      return Error{
          Error::Kind::Schema, std::string(where), {}, "names an unknown dimension \"" + spread.dimension + "\""};
    again.counts.balance.push_back({*dimension, spread.values, spread.effective, spread.variation});
  }
  for (const auto& [path, file] : manifest.files) again.files[path] = {file.bytes, file.sha256};
  for (const auto& source : manifest.sources) again.sources.push_back({source.source, source.origin, source.license});
  again.writing = written_again(manifest.writing);
  if (const auto& reviews = manifest.reviews) again.reviews = {reviews->accepted, reviews->rejected, reviews->edited};
  return again;
}

}  // namespace unietp
