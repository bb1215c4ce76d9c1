#include "pipeline/task_lines.h"

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/text.h"
#include "scene/scene_json.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

std::string text_at(const Json& json, const char* pointer) {
  return json.at(Json::json_pointer(pointer)).get<std::string>();
}

Result<TaskLine> task_line(const std::string& where, const std::string& line) {
  TaskLine task;
  task.text = line;
  const Json json = Json::parse(line);
  task.id = text_at(json, "/id");
  task.scene = text_at(json, "/scene");
  task.layout = text_at(json, "/layout");
  const auto& seed = json.at("seed");
  task.seed = seed.at("run").get<std::uint64_t>();
  task.slot = seed.at("slot").get<int>();
  task.attempt = seed.at("attempt").get<int>();

  Specification& specification = task.specification;
  specification.template_name = text_at(json, "/template");
  specification.style = text_at(json, "/instruction/style");
  specification.refinement = json.at("refinement").get<std::string>();
  const auto split = split_named(text_at(json, "/split"));
  const auto simulator = simulator_named(text_at(json, "/simulator"));
  if (!split || !simulator) return Error{Error::Kind::Schema, where, {}, "names an unknown split or simulator"};
  specification.split = *split;
  specification.simulator = *simulator;
  for (const auto& [placeholder, category] : json.at("bindings").items())
    specification.binding.emplace_back(placeholder, category.get<std::string>());
  auto goal = parse_formula(where, text_at(json, "/goal/text"), FormulaUse::Goal);
  if (!goal) return goal.error();
  specification.goal = std::move(*goal);
  for (const auto& text : json.at(Json::json_pointer("/start/constraints"))) {
    auto formula = parse_formula(where, text.get<std::string>(), FormulaUse::State);
    if (!formula) return formula.error();
    specification.init.push_back(std::move(*formula));
  }
  return task;
}

}  // namespace

Result<std::vector<TaskLine>> read_task_lines(const std::filesystem::path& folder) {
  const auto file = folder / "tasks.jsonl";
  const auto text = read_file(file);
  if (!text) return text.error();
  std::vector<TaskLine> tasks;
  int number = 0;
  for (const auto& line : split(*text, '\n')) {
    ++number;
    if (line.empty()) continue;
    try {
      auto task = task_line(file.string(), line);
      if (!task) {
        Error error = task.error();
        error.pos = {number, error.pos.column};
        return error;
      }
      tasks.push_back(std::move(*task));
    } catch (const Json::exception& reason) {
      return Error{Error::Kind::Schema, file.string(), {number, 1}, std::string("expected a task: ") + reason.what()};
    }
  }
  return tasks;
}

Result<Scene> read_start(const std::filesystem::path& folder, const TaskLine& task) {
  const auto file = folder / "scenes" / (task.scene + ".scene.json.gz");
  const auto text = read_maybe_gzip(file);
  if (!text) return text.error();
  return scene_from_json(file.string(), *text);
}

}  // namespace unietp
