#include "validator/task_record.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "scene/json_parse.h"
#include "scene/json_reader.h"
#include "scene/scene_json.h"
#include "validator/tree_reader.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

std::string line_name(std::string_view where, int line) { return std::string(where) + ":" + std::to_string(line); }

/// One line of a JSON-lines file; the position of a syntax error is that in the file.
Result<Json> parse_line(std::string_view where, int line, std::string_view text) {
  auto json = parse_json(where, text);
  if (json) return json;
  Error error = json.error();
  error.pos = {line, error.pos.column > 0 ? error.pos.column : 1};
  return error;
}

std::string text_or_empty(JsonReader& reader, const JsonAt& at) {
  const auto* text = at.json.get_ptr<const Json::string_t*>();
  return text != nullptr && text->empty() ? std::string() : reader.text(at);
}

int whole(JsonReader& reader, const JsonAt& at) {
  const double value = reader.number(at);
  if (reader.error()) return 0;
  const bool fits = value >= 0 && value <= 1e9 && value == std::floor(value);
  if (!fits) reader.fail(at, "expected a whole number from 0 to 1e9");
  return fits ? static_cast<int>(value) : 0;
}

void read_format(JsonReader& reader, JsonFields& fields, std::string_view expected) {
  if (const auto f = fields.required("format")) {
    const auto format = reader.text(*f);
    if (format != expected)
      reader.fail(*f, "expected the format " + in_quotes(expected) + ", not " + in_quotes(format));
  }
}

void read_goal(JsonReader& reader, const JsonAt& at, TaskRecord& task) {
  JsonFields fields(reader, at);
  if (const auto f = fields.required("text")) task.goal_text = reader.text(*f);
  if (const auto f = fields.required("tree")) task.goal_tree = read_tree(reader, *f);
  fields.finish();
}

void read_start(JsonReader& reader, const JsonAt& at, TaskRecord& task) {
  JsonFields fields(reader, at);
  if (const auto f = fields.required("constraints")) task.start_constraints = reader.texts(*f);
  if (const auto f = fields.required("edits")) task.edits = reader.texts(*f);
  fields.finish();
}

void read_instruction(JsonReader& reader, const JsonAt& at, TaskRecord& task) {
  JsonFields fields(reader, at);
  if (const auto f = fields.required("text")) task.instruction = reader.text(*f);
  if (const auto f = fields.required("writer")) task.writer = reader.text(*f);
  if (const auto f = fields.required("style")) task.style = reader.text(*f);
  if (const auto f = fields.required("checks")) (void)reader.texts(*f);
  if (const auto f = fields.optional("why")) (void)reader.text(*f);
  fields.finish();
}

void read_expert(JsonReader& reader, const JsonAt& at, TaskRecord& task) {
  JsonFields modes(reader, at);
  for (const Mode mode : kModes) {
    const auto f = mode == Mode::M1 ? modes.required(name_of(mode)) : modes.optional(name_of(mode));
    if (!f) continue;
    TaskRecord::Count count{mode};
    JsonFields fields(reader, *f);
    if (const auto steps = fields.required("steps")) count.steps = whole(reader, *steps);
    if (const auto failures = fields.required("failures")) count.failures = whole(reader, *failures);
    fields.finish();
    task.expert.push_back(count);
  }
  modes.finish();
}

void read_seed(JsonReader& reader, const JsonAt& at, TaskRecord& task) {
  JsonFields fields(reader, at);
  if (const auto f = fields.required("run")) {
    (void)reader.number(*f);
    if (f->json.is_number_integer()) task.run = f->json.get<std::uint64_t>();  // a double would lose digits
  }
  if (const auto f = fields.required("slot")) task.slot = whole(reader, *f);
  if (const auto f = fields.required("attempt")) task.attempt = whole(reader, *f);
  fields.finish();
}

void read_bindings(JsonReader& reader, const JsonAt& at, TaskRecord& task) {
  JsonFields fields(reader, at);
  if (reader.error()) return;
  for (const auto& [placeholder, category] : at.json.items()) {
    if (const auto f = fields.required(placeholder)) task.bindings.emplace_back(placeholder, reader.text(*f));
  }
}

std::vector<VisibleObject> read_visible(JsonReader& reader, const JsonAt& at) {
  std::vector<VisibleObject> visible;
  const std::size_t count = reader.items(at);
  for (std::size_t i = 0; i < count && !reader.error(); ++i) {
    const JsonAt item = reader.item(at, i);
    JsonFields fields(reader, item);
    VisibleObject object;
    if (const auto f = fields.required("id")) object.id = reader.text(*f);
    if (const auto f = fields.required("box")) {
      if (reader.items(*f) != object.box.size()) reader.fail(*f, "expected [x0, y0, x1, y1]");
      for (std::size_t k = 0; k < object.box.size() && !reader.error(); ++k)
        object.box[k] = whole(reader, reader.item(*f, k));
    }
    fields.finish();
    visible.push_back(std::move(object));
  }
  return visible;
}

/// A value of scene/ with a reader of its own; its error gets the way to it.
template <class T>
T read_part(JsonReader& reader, const JsonAt& at, Result<T> (*read)(std::string_view, const Json&), const Json& json) {
  auto value = read("", json);
  if (value) return std::move(*value);
  const auto& inner = value.error().where;
  reader.fail(at.pointer() + (inner.empty() || inner[0] != '#' ? "" : inner.substr(1)), value.error().message);
  return {};
}

void check_command(JsonReader& reader, const JsonAt& action, const JsonAt& args, const Command& command) {
  if (reader.error()) return;
  const auto type = action_named(command.action);
  if (!type) {
    std::vector<std::string> names;
    for (const auto list : {all_actions(), extension_actions()}) {
      for (const ActionInfo& known : list) names.emplace_back(known.name);
    }
    reader.unknown_name(action, "action", names);
    return;
  }
  const std::size_t wanted = info(*type).argument == ActionArgument::None ? 0 : 1;
  if (command.args.size() != wanted)
    reader.fail(args, command.action + " takes " + (wanted == 0 ? "no argument" : "one argument"));
}

StepRecord read_step(JsonReader& reader, const JsonAt& at) {
  JsonFields fields(reader, at);
  StepRecord step;
  const auto action = fields.required("action");
  const auto args = fields.required("args");
  if (action && args) {
    step.command = read_part(reader, at, command_from_json, Json{{"action", action->json}, {"args", args->json}});
    check_command(reader, *action, *args, step.command);
  }
  if (const auto f = fields.required("success")) step.success = reader.boolean(*f);
  if (const auto f = fields.required("failure")) step.failure = reader.text(*f);
  if (const auto f = fields.required("feedback")) step.feedback = text_or_empty(reader, *f);
  if (const auto f = fields.required("visible")) step.visible = read_visible(reader, *f);
  if (const auto f = fields.required("changes")) step.changes = read_part(reader, *f, delta_from_json, f->json);
  fields.finish();
  return step;
}

}  // namespace

Result<TaskRecord> read_task(std::string_view where, int line, std::string_view text) {
  const auto json = parse_line(where, line, text);
  if (!json) return json.error();
  const auto name = line_name(where, line);
  JsonReader reader(name);
  const JsonAt root{*json};
  JsonFields fields(reader, root);
  TaskRecord task;
  read_format(reader, fields, "unietp-task/1");
  if (const auto f = fields.required("id")) task.id = reader.text(*f);
  if (const auto f = fields.required("template")) task.template_name = reader.text(*f);
  if (const auto f = fields.required("split")) task.split = reader.text(*f);
  if (const auto f = fields.required("simulator")) task.simulator = reader.text(*f);
  if (const auto f = fields.required("scene")) task.scene = reader.text(*f);
  if (const auto f = fields.required("layout")) task.layout = reader.text(*f);
  if (const auto f = fields.required("bindings")) read_bindings(reader, *f, task);
  if (const auto f = fields.required("refinement")) task.refinement = text_or_empty(reader, *f);
  if (const auto f = fields.required("goal")) read_goal(reader, *f, task);
  if (const auto f = fields.required("start")) read_start(reader, *f, task);
  if (const auto f = fields.required("instruction")) read_instruction(reader, *f, task);
  if (const auto f = fields.required("expert")) read_expert(reader, *f, task);
  if (const auto f = fields.required("seed")) read_seed(reader, *f, task);
  fields.finish();
  if (reader.error()) return *reader.error();
  return task;
}

Result<DemonstrationRecord> read_demonstration(std::string_view where, int line, std::string_view text) {
  const auto json = parse_line(where, line, text);
  if (!json) return json.error();
  const auto name = line_name(where, line);
  JsonReader reader(name);
  const JsonAt root{*json};
  JsonFields fields(reader, root);
  DemonstrationRecord demonstration;
  read_format(reader, fields, "unietp-demonstration/1");
  if (const auto f = fields.required("task")) demonstration.task = reader.text(*f);
  if (const auto f = fields.required("mode")) demonstration.mode = reader.text(*f);
  if (const auto f = fields.required("steps")) {
    const std::size_t count = reader.items(*f);
    for (std::size_t i = 0; i < count && !reader.error(); ++i)
      demonstration.steps.push_back(read_step(reader, reader.item(*f, i)));
  }
  fields.finish();
  if (reader.error()) return *reader.error();
  return demonstration;
}

}  // namespace unietp
