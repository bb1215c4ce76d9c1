#include "dataset/lines.h"

#include <nlohmann/json.hpp>

#include "annotator/phenomena.h"
#include "dataset/formula_json.h"
#include "scene/json_text.h"
#include "scene/scene_json.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// Writes the fields of one object.
class ObjectText {
 public:
  explicit ObjectText(std::string_view format) : json_(text_) {
    json_.open_object();
    field("format", format);
  }
  void field(std::string_view name, const Json& value) { raw(name, dumped(value)); }
  void raw(std::string_view name, std::string_view written) {
    json_.key(name);
    json_.raw(written);
  }
  std::string finish() {
    json_.close_object();
    return std::move(text_);
  }

 private:
  std::string text_;
  JsonText json_;
};

Json instruction_json(const Instruction& instruction) {
  Json json{{"text", instruction.text},
            {"writer", instruction.writer},
            {"style", name_of(instruction.style)},
            {"checks", instruction.checks}};
  if (!instruction.why.empty()) json["why"] = instruction.why;
  if (instruction.phrasing > 0) json["phrasing"] = instruction.phrasing;
  return json;
}

Json sense_json(const TaskSense& sense) {
  Json parts = Json::array();
  for (const auto& part : sense.parts)
    parts.push_back({{"part", part.part}, {"grade", name_of(part.sense.grade)}, {"why", part.sense.why}});
  return {{"grade", name_of(sense.grade)}, {"parts", std::move(parts)}};
}

std::string start_text(const TaskEntry& task) {
  std::string text;
  JsonText json(text);
  json.open_object();
  json.key("constraints");
  json.raw(dumped(task.start_constraints));
  json.key("edits");
  json.raw(dumped(task.edits));
  json.key("changes");
  json.raw(task.changes);
  json.close_object();
  return text;
}

void write_command(JsonText& json, const Command& command) {
  const Json object = command_to_json(command);
  for (const auto& [name, value] : object.items()) {
    json.key(name);
    json.raw(dumped(value));
  }
}

void write_step(JsonText& json, const StepEntry& step) {
  json.open_object();
  write_command(json, step.command);
  json.key("success");
  json.value(step.success);
  json.key("failure");
  json.value(step.failure);
  json.key("feedback");
  json.value(step.feedback);
  json.key("search");
  json.value(step.search);
  if (step.tidying) {
    json.key("tidying");
    json.value(true);
  }
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
  if (!step.moments.empty()) {
    json.key("moments");
    json.open_list();
    for (const Delta& moment : step.moments) json.raw(delta_to_json(moment));
    json.close_list();
  }
  json.close_object();
}

void write_plan(JsonText& json, std::string_view name, const std::vector<Command>& plan) {
  json.key(name);
  json.open_list();
  for (const Command& command : plan) {
    json.open_object();
    write_command(json, command);
    json.close_object();
  }
  json.close_list();
}

}  // namespace

std::string line_of(const TaskEntry& task) {
  Json bindings = Json::object();
  for (const auto& [placeholder, category] : task.bindings) bindings[placeholder] = category;
  Json expert = Json::object();
  for (const auto& count : task.expert) {
    Json& shown = expert[std::string(name_of(count.mode))] = {{"steps", count.steps}, {"failures", count.failures}};
    if (count.mode != Mode::M1 || count.shortest != 0) shown["shortest_steps"] = count.shortest;
  }
  ObjectText object("unietp-task/1");
  object.field("id", task.id);
  object.field("template", task.template_name);
  object.field("split", task.split);
  object.field("simulator", task.simulator);
  object.field("scene", task.scene);
  object.field("layout", task.layout);
  object.field("bindings", bindings);
  object.field("refinement", task.refinement);
  object.field("phenomena", names_of(task.instruction.phenomena));
  object.field("goal", {{"text", task.goal_text}, {"tree", formula_to_json(task.goal)}});
  object.raw("start", start_text(task));
  object.field("instruction", instruction_json(task.instruction));
  if (!task.purpose.name.empty())
    object.field("purpose", {{"name", task.purpose.name}, {"because", task.purpose.because}});
  object.field("sense", sense_json(task.sense));
  object.field("forms", task.forms);
  object.field("expert", expert);
  object.field("seed", {{"run", task.run_seed}, {"slot", task.slot}, {"attempt", task.attempt}});
  return object.finish();
}

std::string demonstration_line(std::string_view task, Mode mode, const std::vector<StepEntry>& steps,
                               const PlansBeside& beside) {
  std::string line;
  JsonText json(line);
  json.open_object();
  json.key("format");
  json.value("unietp-demonstration/1");
  json.key("task");
  json.value(task);
  json.key("mode");
  json.value(name_of(mode));
  json.key("steps");
  json.open_list();
  for (const auto& step : steps) write_step(json, step);
  json.close_list();
  if (mode != Mode::M1) write_plan(json, "shortest", beside.shortest);
  if (!beside.tempting.empty()) write_plan(json, "tempting", beside.tempting);
  json.close_object();
  return line;
}

std::string line_of(const RejectionEntry& rejection) {
  return dumped({{"format", "unietp-rejection/1"},
                 {"slot", rejection.slot},
                 {"attempt", rejection.attempt},
                 {"template", rejection.template_name},
                 {"simulator", rejection.simulator},
                 {"split", rejection.split},
                 {"stage", rejection.stage},
                 {"reason", rejection.reason},
                 {"detail", rejection.detail}});
}

std::string line_of(const WordingsEntry& wordings) {
  Json json{{"format", "unietp-wordings/1"},
            {"task", wordings.task},
            {"pair", wordings.task},
            {"direct", instruction_json(wordings.direct)}};
  if (wordings.referring) {
    json["referring"] = instruction_json(*wordings.referring);
    json["referring"]["goal"] = wordings.referring_goal;
  }
  if (wordings.complex) json["complex"] = instruction_json(*wordings.complex);
  if (wordings.contrast) {
    json["contrast"] = instruction_json(*wordings.contrast);
    json["contrast"]["goal"] = wordings.contrast_goal;
  }
  for (const Instruction& other : wordings.others) json["others"].push_back(instruction_json(other));
  return dumped(json);
}

std::string line_of(const ReviewMarkEntry& mark) {
  Json json{{"format", "unietp-review-mark/1"}, {"task", mark.task}, {"verdict", mark.verdict}};
  if (!mark.before.empty()) json["before"] = mark.before;
  json["comment"] = mark.comment;
  return dumped(json);
}

Result<LinesWriter> LinesWriter::begin(const std::filesystem::path& path) {
  auto file = FileWriter::begin(path);
  if (!file) return file.error();
  return LinesWriter(std::move(*file));
}

Result<Done> LinesWriter::add(std::string_view line) {
  auto added = file_.add(line);
  return added ? file_.add("\n") : added;
}

Result<Done> LinesWriter::finish() { return file_.finish(); }

}  // namespace unietp
