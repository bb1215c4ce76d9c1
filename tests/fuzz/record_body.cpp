#include <nlohmann/json.hpp>

#include "bodies.h"
#include "fuzz_bodies.h"
#include "scene/scene_json.h"
#include "support.h"
#include "validator/manifest_check.h"
#include "validator/task_record.h"

namespace unietp::fuzz {

bool task_body(std::string_view text) {
  const auto task = read_task("fuzz", 1, text);
  if (!task) {
    check_error(task.error());
    return false;
  }
  for (const auto& count : task->expert) require(count.steps >= 0 && count.failures >= 0);
  const auto goal = parse_formula("fuzz", task->goal_text, FormulaUse::Goal);
  if (goal && *goal == task->goal_tree) check_formula(task->goal_tree, FormulaUse::Goal);
  return true;
}

bool demonstration_body(std::string_view text) {
  const auto demonstration = read_demonstration("fuzz", 1, text);
  if (!demonstration) {
    check_error(demonstration.error());
    return false;
  }
  for (const StepRecord& step : demonstration->steps) {
    const auto command = command_from_json("fuzz", command_to_json(step.command));
    require(command && *command == step.command);
    const auto changes = delta_from_json("fuzz", nlohmann::ordered_json::parse(delta_to_json(step.changes)));
    require(changes && *changes == step.changes);
  }
  return true;
}

bool manifest_body(std::string_view text) {
  static const Folder folder("manifest");
  folder.write("a.txt", "alpha");
  folder.write("manifest.json", text);
  const ManifestCheck check = check_manifest(folder.path(), "digest");
  for (const Error& error : check.errors) check_error(error);
  require(check.tasks >= -1);
  require(check.tasks >= 0 || !check.errors.empty());
  return check.errors.empty();
}

}  // namespace unietp::fuzz
