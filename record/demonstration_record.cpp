#include <array>

#include <nlohmann/json.hpp>

#include "record/record_fields.h"
#include "record/task_record.h"
#include "scene/scene_json.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

std::vector<VisibleObject> read_visible(JsonReader& reader, const JsonAt& at) {
  std::vector<VisibleObject> visible;
  const std::size_t count = reader.items(at);
  for (std::size_t i = 0; i < count && !reader.error(); ++i) {
    const JsonAt item = reader.item(at, i);
    JsonFields fields(reader, item);
    VisibleObject object;
    if (const auto f = fields.required("id")) object.id = reader.label(*f);
    if (const auto f = fields.required("box")) {
      if (reader.items(*f) != object.box.size()) reader.fail(*f, "expected [x0, y0, x1, y1]");
      for (std::size_t k = 0; k < object.box.size() && !reader.error(); ++k)
        object.box[k] = read_whole(reader, reader.item(*f, k));
    }
    fields.finish();
    visible.push_back(std::move(object));
  }
  return visible;
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

Command read_command(JsonReader& reader, const JsonAt& at, JsonFields& fields) {
  Command command;
  const auto action = fields.required("action");
  const auto args = fields.required("args");
  if (action && args) {
    command = read_part(reader, at, command_from_json, Json{{"action", action->json}, {"args", args->json}});
    check_command(reader, *action, *args, command);
  }
  return command;
}

StepRecord read_step(JsonReader& reader, const JsonAt& at) {
  JsonFields fields(reader, at);
  StepRecord step;
  step.command = read_command(reader, at, fields);
  if (const auto f = fields.required("success")) step.success = reader.boolean(*f);
  if (const auto f = fields.required("failure")) step.failure = reader.text(*f);
  if (const auto f = fields.required("feedback")) step.feedback = text_or_empty(reader, *f);
  if (const auto f = fields.required("search")) step.search = reader.boolean(*f);
  if (const auto f = fields.optional("tidying")) step.tidying = reader.boolean(*f);
  if (const auto f = fields.required("visible")) step.visible = read_visible(reader, *f);
  if (const auto f = fields.required("changes")) step.changes = read_part(reader, *f, delta_from_json, f->json);
  if (const auto f = fields.optional("moments")) step.moments = read_moments(reader, *f);
  fields.finish();
  return step;
}

std::vector<Command> read_plan(JsonReader& reader, const JsonAt& at) {
  std::vector<Command> plan;
  const std::size_t count = reader.items(at);
  for (std::size_t i = 0; i < count && !reader.error(); ++i) {
    const JsonAt item = reader.item(at, i);
    JsonFields command(reader, item);
    plan.push_back(read_command(reader, item, command));
    command.finish();
  }
  return plan;
}

}  // namespace

std::vector<Delta> changes_by_moment(const DemonstrationRecord& demonstration) {
  std::vector<Delta> changes;
  for (const StepRecord& step : demonstration.steps) {
    if (step.moments.empty()) changes.push_back(step.changes);
    changes.insert(changes.end(), step.moments.begin(), step.moments.end());
  }
  return changes;
}

Result<DemonstrationRecord> read_demonstration(std::string_view where, int line, std::string_view text) {
  DemonstrationRecord demonstration;
  const auto read = read_line(where, line, text, "unietp-demonstration/1", [&](JsonReader& reader, JsonFields& fields) {
    if (const auto f = fields.required("task")) demonstration.task = reader.plain_name(*f);
    if (const auto f = fields.required("mode")) demonstration.mode = reader.plain_name(*f);
    if (const auto f = fields.required("steps")) {
      const std::size_t count = reader.items(*f);
      for (std::size_t i = 0; i < count && !reader.error(); ++i)
        demonstration.steps.push_back(read_step(reader, reader.item(*f, i)));
    }
    if (const auto f = fields.optional("shortest")) demonstration.shortest = read_plan(reader, *f);
    if (const auto f = fields.optional("tempting")) demonstration.tempting = read_plan(reader, *f);
  });
  if (!read) return read.error();
  return demonstration;
}

Result<DemonstratedPlan> read_demonstrated_plan(std::string_view where, int line, std::string_view text) {
  static constexpr std::array<std::string_view, 11> kLeftOut{"mode",    "shortest", "tempting", "success",
                                                             "failure", "feedback", "visible",  "changes",
                                                             "moments", "search",   "tidying"};
  DemonstratedPlan plan;
  const auto read = [&](JsonReader& reader, JsonFields& fields) {
    if (const auto f = fields.required("task")) plan.task = reader.plain_name(*f);
    if (const auto f = fields.required("steps")) plan.commands = read_plan(reader, *f);
  };
  if (auto done = read_line(where, line, text, "unietp-demonstration/1", read, kLeftOut); !done) return done.error();
  return plan;
}

}  // namespace unietp
