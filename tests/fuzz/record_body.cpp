#include <nlohmann/json.hpp>

#include "bodies.h"
#include "fuzz_bodies.h"
#include "record/manifest_record.h"
#include "record/task_record.h"
#include "record/wordings_record.h"
#include "scene/scene_json.h"
#include "support.h"

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

bool wordings_body(std::string_view text) {
  const auto wordings = read_wordings("fuzz", 1, text);
  if (!wordings) {
    check_error(wordings.error());
    return false;
  }
  require(wordings->wordings.contains("direct"));
  for (const auto& [kind, wording] : wordings->wordings) require(!wording.text.empty());
  return true;
}

bool rejection_body(std::string_view text) {
  const auto rejection = read_rejection("fuzz", 1, text);
  if (!rejection) {
    check_error(rejection.error());
    return false;
  }
  require(rejection->slot >= 0 && rejection->attempt >= 0 && !rejection->reason.empty());
  return true;
}

bool manifest_body(std::string_view text) {
  const auto manifest = read_manifest("fuzz", text);
  if (!manifest) {
    check_error(manifest.error());
    return false;
  }
  require(manifest->tasks >= 0 && manifest->run.count >= 0);
  return true;
}

}  // namespace unietp::fuzz
