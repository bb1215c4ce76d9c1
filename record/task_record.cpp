#include "record/task_record.h"

#include <nlohmann/json.hpp>

#include "logic/formula_size.h"
#include "record/record_fields.h"
#include "record/tree_reader.h"
#include "scene/json_reader.h"
#include "scene/scene_json.h"

namespace unietp {
namespace {

void read_goal(JsonReader& reader, const JsonAt& at, TaskRecord& task) {
  JsonFields fields(reader, at);
  if (const auto f = fields.required("text")) task.goal_text = reader.line(*f);
  if (const auto f = fields.required("tree")) {
    task.goal_tree = read_tree(reader, *f);
    if (const auto excess = excess_of(task.goal_tree); !excess.empty()) reader.fail(*f, excess);
  }
  fields.finish();
}

void read_start(JsonReader& reader, const JsonAt& at, TaskRecord& task) {
  JsonFields fields(reader, at);
  if (const auto f = fields.required("constraints")) task.start_constraints = reader.texts(*f);
  if (const auto f = fields.required("edits")) task.edits = reader.texts(*f);
  if (const auto f = fields.required("changes")) task.changes = read_part(reader, *f, delta_from_json, f->json);
  fields.finish();
}

void read_instruction(JsonReader& reader, const JsonAt& at, TaskRecord& task) {
  JsonFields fields(reader, at);
  if (const auto f = fields.required("text")) task.instruction = reader.line(*f);
  if (const auto f = fields.required("writer")) task.writer = reader.text(*f);
  if (const auto f = fields.required("style")) task.style = reader.text(*f);
  if (const auto f = fields.required("checks")) task.checks = reader.texts(*f);
  if (const auto f = fields.optional("why")) task.fallback = reader.text(*f);
  if (const auto f = fields.optional("phrasing")) task.phrasing = read_whole(reader, *f);
  fields.finish();
}

void read_purpose(JsonReader& reader, const JsonAt& at, TaskRecord& task) {
  JsonFields fields(reader, at);
  if (const auto f = fields.required("name")) task.purpose = reader.plain_name(*f);
  if (const auto f = fields.required("because")) task.because = reader.texts(*f);
  fields.finish();
}

void read_sense(JsonReader& reader, const JsonAt& at, TaskRecord& task) {
  JsonFields fields(reader, at);
  if (const auto f = fields.required("grade")) task.grade = reader.text(*f);
  if (const auto f = fields.required("parts")) {
    for (std::size_t i = 0; i < reader.items(*f) && !reader.error(); ++i) {
      const JsonAt item = reader.item(*f, i);
      JsonFields own(reader, item);
      auto& part = task.sense.emplace_back();
      if (const auto text = own.required("part")) part.part = reader.line(*text);
      if (const auto text = own.required("grade")) part.grade = reader.text(*text);
      if (const auto text = own.required("why")) part.why = reader.text(*text);
      own.finish();
    }
  }
  fields.finish();
}

void read_expert(JsonReader& reader, const JsonAt& at, TaskRecord& task) {
  JsonFields modes(reader, at);
  for (const Mode mode : kModes) {
    const auto f = mode == Mode::M1 ? modes.required(name_of(mode)) : modes.optional(name_of(mode));
    if (!f) continue;
    TaskRecord::Count count{mode};
    JsonFields fields(reader, *f);
    if (const auto steps = fields.required("steps")) count.steps = read_whole(reader, *steps);
    if (const auto failures = fields.required("failures")) count.failures = read_whole(reader, *failures);
    const auto shortest = mode == Mode::M1 ? fields.optional("shortest_steps") : fields.required("shortest_steps");
    if (shortest) count.shortest = read_whole(reader, *shortest);
    fields.finish();
    task.expert.push_back(count);
  }
  modes.finish();
}

void read_seed(JsonReader& reader, const JsonAt& at, TaskRecord& task) {
  JsonFields fields(reader, at);
  if (const auto f = fields.required("run")) task.run = read_seed(reader, *f);
  if (const auto f = fields.required("slot")) task.slot = read_whole(reader, *f);
  if (const auto f = fields.required("attempt")) task.attempt = read_whole(reader, *f);
  fields.finish();
}

void read_bindings(JsonReader& reader, const JsonAt& at, TaskRecord& task) {
  JsonFields fields(reader, at);
  if (reader.error()) return;
  for (const auto& [placeholder, category] : at.json.items()) {
    if (const auto f = fields.required(placeholder)) task.bindings.emplace_back(placeholder, reader.label(*f));
  }
}

}  // namespace

Result<TaskRecord> read_task(std::string_view where, int line, std::string_view text) {
  TaskRecord task;
  const auto read = read_line(where, line, text, "unietp-task/1", [&](JsonReader& reader, JsonFields& fields) {
    if (const auto f = fields.required("id")) task.id = reader.plain_name(*f);
    if (const auto f = fields.required("template")) task.template_name = reader.plain_name(*f);
    if (const auto f = fields.required("split")) task.split = reader.plain_name(*f);
    if (const auto f = fields.required("simulator")) task.simulator = reader.plain_name(*f);
    if (const auto f = fields.required("scene")) task.scene = reader.plain_name(*f);
    if (const auto f = fields.required("layout")) task.layout = reader.plain_name(*f);
    if (const auto f = fields.required("bindings")) read_bindings(reader, *f, task);
    if (const auto f = fields.required("refinement")) task.refinement = text_or_empty(reader, *f);
    if (const auto f = fields.required("phenomena")) task.phenomena = reader.texts(*f);
    if (const auto f = fields.required("goal")) read_goal(reader, *f, task);
    if (const auto f = fields.required("start")) read_start(reader, *f, task);
    if (const auto f = fields.required("instruction")) read_instruction(reader, *f, task);
    if (const auto f = fields.optional("purpose")) read_purpose(reader, *f, task);
    if (const auto f = fields.required("sense")) read_sense(reader, *f, task);
    if (const auto f = fields.required("forms")) task.forms = reader.texts(*f);
    if (const auto f = fields.required("expert")) read_expert(reader, *f, task);
    if (const auto f = fields.required("seed")) read_seed(reader, *f, task);
  });
  if (!read) return read.error();
  return task;
}

}  // namespace unietp
