#include "dataset/candidate.h"

#include <nlohmann/json.hpp>

#include "core/digest.h"
#include "core/text.h"
#include "dataset/formula_json.h"
#include "dataset/instruction_json.h"
#include "scene/json_text.h"
#include "scene/scene_json.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

std::string line_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Json binding_json(const Binding& binding) {
  Json json = Json::object();
  for (const auto& [placeholder, category] : binding) json[placeholder] = category;
  return json;
}

Json demonstration_summary(const Demonstration& demonstration) {
  int failures = 0;
  for (const auto& step : demonstration.steps) failures += step.outcome.success ? 0 : 1;
  return {{"steps", demonstration.steps.size()}, {"failures", failures}};
}

/// What the start must be, what was done to the home for it, and what is different there now.
std::string start_text(const Task& task, const std::string& changes) {
  Json constraints = Json::array();
  for (const auto& formula : task.episode.specification.init) constraints.push_back(to_text(formula));
  std::string text;
  JsonText json(text);
  json.open_object();
  json.key("constraints");
  json.raw(line_of(constraints));
  json.key("edits");
  json.raw(line_of(task.episode.edits));
  json.key("changes");
  json.raw(changes);
  json.close_object();
  return text;
}

std::string task_line(const Task& task, const std::string& changes) {
  const auto& specification = task.episode.specification;
  Json expert = Json::object();
  expert[std::string(name_of(task.demonstration.mode))] = demonstration_summary(task.demonstration);
  for (const auto& other : task.in_other_modes) expert[std::string(name_of(other.mode))] = demonstration_summary(other);
  std::string line;
  JsonText json(line);
  const auto field = [&json](std::string_view name, const Json& value) {
    json.key(name);
    json.raw(line_of(value));
  };
  json.open_object();
  field("format", "unietp-task/1");
  field("id", task.id);
  field("template", specification.template_name);
  field("split", name_of(specification.split));
  field("simulator", name_of(specification.simulator));
  field("scene", task.episode.start.id);
  field("layout", task.episode.layout);
  field("bindings", binding_json(specification.binding));
  field("refinement", specification.refinement);
  field("goal", {{"text", to_text(specification.goal)}, {"tree", formula_to_json(specification.goal)}});
  json.key("start");
  json.raw(start_text(task, changes));
  field("instruction", instruction_to_json(task.instruction));
  field("expert", expert);
  field("seed", {{"run", task.seed}, {"slot", task.slot}, {"attempt", task.attempt}});
  json.close_object();
  return line;
}

/// What was done and how it went, in an object that is left open.
void write_action(JsonText& json, const DemonstrationStep& step) {
  json.open_object();
  const Json command = command_to_json(step.command);
  for (const auto& [name, value] : command.items()) {
    json.key(name);
    json.raw(line_of(value));
  }
  json.key("success");
  json.value(step.outcome.success);
  json.key("failure");
  json.value(name_of(step.outcome.failure));
}

void write(JsonText& json, const DemonstrationStep& step) {
  write_action(json, step);
  json.key("feedback");
  json.value(step.outcome.feedback);
  json.key("visible");
  json.open_list();
  for (const auto& object : step.visible) {
    json.open_object();
    json.key("id");
    json.value(object.id);
    json.key("box");
    json.open_list();
    for (const int edge : object.box) json.value(edge);
    json.close_list();
    json.close_object();
  }
  json.close_list();
  json.key("changes");
  json.raw(delta_to_json(step.changes));
  json.close_object();
}

std::string demonstration_line(const Task& task, const Demonstration& demonstration) {
  std::string line;
  JsonText json(line);
  json.open_object();
  json.key("format");
  json.value("unietp-demonstration/1");
  json.key("task");
  json.value(task.id);
  json.key("mode");
  json.value(name_of(demonstration.mode));
  json.key("steps");
  json.open_list();
  for (const auto& step : demonstration.steps) write(json, step);
  json.close_list();
  json.close_object();
  return line;
}

std::string actions_line(const Demonstration& demonstration) {
  std::string line;
  JsonText json(line);
  json.open_object();
  json.key("mode");
  json.value(name_of(demonstration.mode));
  json.key("steps");
  json.open_list();
  for (const auto& step : demonstration.steps) {
    write_action(json, step);
    json.close_object();
  }
  json.close_list();
  json.close_object();
  return line;
}

std::string actions_lines(const Task& task) {
  std::string lines = actions_line(task.demonstration);
  for (const auto& other : task.in_other_modes) lines += "\n" + actions_line(other);
  return lines;
}

std::string demonstration_lines(const Task& task) {
  std::string lines = demonstration_line(task, task.demonstration);
  for (const auto& other : task.in_other_modes) lines += "\n" + demonstration_line(task, other);
  return lines;
}

std::string rejection_text(int slot, int attempt, std::string_view template_name, std::string_view simulator,
                           std::string_view split, const Rejection& rejection) {
  return line_of({{"format", "unietp-rejection/1"},
                  {"slot", slot},
                  {"attempt", attempt},
                  {"template", template_name},
                  {"simulator", simulator},
                  {"split", split},
                  {"stage", name_of(stage_of(rejection.reason))},
                  {"reason", name_of(rejection.reason)},
                  {"detail", rejection.detail}});
}

/// Key of what is done in which start: equal starts of a home have equal texts of their changes.
std::string start_key(const Task& task, const std::string& changes) {
  const auto& specification = task.episode.specification;
  std::string key = specification.template_name + "\n" + line_of(binding_json(specification.binding)) + "\n" +
                    to_text(specification.goal) + "\n" + task.episode.layout + "\n";
  return sha256(key.append(changes));
}

}  // namespace

Result<std::string> actions_of_line(std::string_view where, std::string_view line) {
  try {
    const auto whole = Json::parse(line);
    Json steps = Json::array();
    for (const auto& step : whole.at("steps")) {
      Json done = Json::object();
      for (const char* part : {"action", "args", "success", "failure"}) done[part] = step.at(part);
      steps.push_back(std::move(done));
    }
    return line_of({{"mode", whole.at("mode")}, {"steps", std::move(steps)}});
  } catch (const Json::exception& reason) {
    return Error{Error::Kind::Parse, std::string(where), {}, std::string("is not a demonstration: ") + reason.what()};
  }
}

std::string rejection_line(const RejectedCandidate& candidate) {
  return rejection_text(candidate.slot, candidate.attempt, candidate.template_name, name_of(candidate.simulator),
                        name_of(candidate.split), candidate.rejection);
}

std::string repetition_line(const CandidateRecord& record, bool same_start) {
  const auto task = Json::parse(record.task);
  return rejection_text(record.slot, record.attempt, record.template_name, task.at("simulator").get<std::string>(),
                        task.at("split").get<std::string>(),
                        {same_start ? RejectionReason::DuplicateStart : RejectionReason::DuplicateText,
                         same_start ? "an earlier task has this template, binding and start"
                                    : "an earlier task in this home has this instruction"});
}

CandidateRecord outline_of(CandidateRecord record) {
  for (auto* text : {&record.task, &record.demonstration, &record.actions, &record.rejection}) *text = {};
  return record;
}

std::string normalised_text(std::string_view text) {
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
    record.rejection = rejection_line(*rejected);
    return record;
  }
  const auto& task = std::get<Task>(candidate);
  record.slot = task.slot;
  record.attempt = task.attempt;
  record.accepted = true;
  record.template_name = task.episode.specification.template_name;
  const std::string changes = delta_to_json(task.episode.changes);
  record.task = task_line(task, changes);
  record.demonstration = demonstration_lines(task);
  record.actions = actions_lines(task);
  record.start_key = start_key(task, changes);
  record.traits = to_text(task.traits);
  record.text_key = sha256(task.episode.layout + "\n" + normalised_text(task.instruction.text));
  return record;
}

}  // namespace unietp
