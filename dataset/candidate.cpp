#include "dataset/candidate.h"

#include <nlohmann/json.hpp>

#include "core/digest.h"
#include "core/text.h"
#include "scene/scene_json.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

StepEntry step_entry(const DemonstrationStep& step) {
  return {step.command,          step.outcome.success, name_of(step.outcome.failure),
          step.outcome.feedback, step.visible,         step.changes,
          step.moments,          step.search,          step.tidying};
}

/// Key of what is done in which start: equal starts of a home have equal texts of their changes.
std::string start_key(const Task& task, const std::string& changes) {
  const auto& specification = task.episode.specification;
  Json binding = Json::object();
  for (const auto& [placeholder, category] : specification.binding) binding[placeholder] = category;
  std::string key = specification.template_name + "\n" + binding.dump(-1, ' ', false, Json::error_handler_t::replace) +
                    "\n" + to_text(specification.goal) + "\n" + task.episode.layout + "\n";
  return sha256(key.append(changes));
}

/// The task's line but for what its demonstrations count.
TaskEntry task_entry(const Task& task, const std::string& changes) {
  const auto& specification = task.episode.specification;
  TaskEntry entry;
  entry.id = task.id;
  entry.template_name = specification.template_name;
  entry.split = name_of(specification.split);
  entry.simulator = name_of(specification.simulator);
  entry.scene = task.episode.start.id;
  entry.layout = task.episode.layout;
  entry.bindings = specification.binding;
  entry.refinement = name_of(specification.refinement);
  entry.goal_text = to_text(specification.goal);
  entry.goal = specification.goal;
  for (const auto& formula : specification.init) entry.start_constraints.push_back(to_text(formula));
  entry.edits = task.episode.edits;
  entry.changes = changes;
  entry.instruction = task.instruction;
  entry.purpose = task.purpose;
  entry.sense = task.sense;
  entry.forms = task.forms;
  entry.run_seed = task.seed;
  entry.slot = task.slot;
  entry.attempt = task.attempt;
  return entry;
}

std::vector<Command> said(const std::vector<Action>& plan) {
  std::vector<Command> commands;
  for (const Action& action : plan) commands.push_back(by_ids(action));
  return commands;
}

WrittenTask written_task(const Task& task, const std::string& changes) {
  TaskEntry entry = task_entry(task, changes);
  WrittenTask written;
  written.row = row_of(entry);
  const auto add = [&](const Demonstration& demonstration) {
    std::vector<StepEntry> steps;
    TaskEntry::Count count{demonstration.mode};
    for (const auto& step : demonstration.steps) {
      steps.push_back(step_entry(step));
      written.row.actions.push_back(action_row(demonstration.mode, steps.back()));
      ++count.steps;
      count.failures += step.outcome.success ? 0 : 1;
    }
    PlansBeside beside{said(demonstration.shortest), said(demonstration.tempting)};
    count.shortest = shortest_steps(demonstration);
    entry.expert.push_back(count);
    written.shown.push_back(demonstration_line(task.id, demonstration.mode, steps, beside));
  };
  add(task.demonstration);
  for (const auto& other : task.in_other_modes) add(other);
  written.line = line_of(entry);
  return written;
}

}  // namespace

TaskRow row_of(const TaskEntry& task) {
  return {task.id,
          task.split,
          task.simulator,
          task.template_name,
          task.scene,
          task.layout,
          task.goal_text,
          task.instruction.text,
          std::string(name_of(task.instruction.style)),
          task.instruction.writer,
          std::string(name_of(task.sense.grade)),
          join(task.forms, " "),
          task.bindings,
          {}};
}

ActionRow action_row(Mode mode, const StepEntry& step) {
  std::vector<std::string> arguments;
  const Json command = command_to_json(step.command);
  for (const auto& argument : command.at("args"))
    arguments.push_back(argument.is_string() ? argument.get<std::string>() : argument.dump());
  return {mode, step.command.action, join(arguments, ", "), step.success, std::string(step.failure)};
}

RejectionEntry repetition_entry(const CandidateRecord& record, bool same_start) {
  const auto reason = same_start ? RejectionReason::DuplicateStart : RejectionReason::DuplicateText;
  return {record.slot,
          record.attempt,
          record.template_name,
          record.task.row.simulator,
          record.task.row.split,
          std::string(name_of(stage_of(reason))),
          std::string(name_of(reason)),
          same_start ? "an earlier task has this template, binding and start"
                     : "an earlier task in this home has this instruction"};
}

CandidateRecord outline_of(CandidateRecord record) {
  record.task = {};
  RejectionEntry why;
  why.reason = std::move(record.rejection.reason);
  record.rejection = std::move(why);
  return record;
}

std::string normalized_text(std::string_view text) {
  std::string words;
  bool gap = false;
  for (const char c : lower(text)) {
    const bool word = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || (static_cast<unsigned char>(c) >= 0x80);
    if (word && gap && !words.empty()) words += ' ';
    if (word) words += c;
    gap = !word;
  }
  return words;
}

CandidateRecord record_of(const std::variant<Task, RejectedCandidate>& candidate) {
  CandidateRecord record;
  if (const auto* rejected = std::get_if<RejectedCandidate>(&candidate)) {
    record.slot = rejected->slot;
    record.attempt = rejected->attempt;
    record.template_name = rejected->template_name;
    record.rejection = {rejected->slot,
                        rejected->attempt,
                        rejected->template_name,
                        std::string(name_of(rejected->simulator)),
                        std::string(name_of(rejected->split)),
                        std::string(name_of(stage_of(rejected->rejection.reason))),
                        std::string(name_of(rejected->rejection.reason)),
                        rejected->rejection.detail};
    return record;
  }
  const auto& task = std::get<Task>(candidate);
  const std::string changes = delta_to_json(task.episode.changes);
  record.slot = task.slot;
  record.attempt = task.attempt;
  record.accepted = true;
  record.task = written_task(task, changes);
  record.template_name = record.task.row.template_name;
  record.start_key = start_key(task, changes);
  record.traits = to_text(task.traits);
  record.text_key = sha256(task.episode.layout + "\n" + normalized_text(task.instruction.text));
  return record;
}

}  // namespace unietp
