#include <algorithm>

#include <nlohmann/json.hpp>

#include "exports/bddl.h"
#include "exports/behavior_abilities.h"
#include "exports/express.h"
#include "exports/moments_of_step.h"
#include "exports/own_scene.h"
#include "interchange/formats.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kRobot = "agent";  // its name in the scene that a runner makes

/// The category of an object that a problem names and that has no model in OmniGibson; "" when all have one.
std::string without_model(const FinishedTask& task, const BddlProblem& problem, const Knowledge& knowledge) {
  for (const auto& [id, name] : problem.names) {
    const Node* const node = find_node(task.start, id);  // none of a half, which comes when the whole is cut
    if (node != nullptr && !has_behavior_model(*node, knowledge)) return node->category;
  }
  return "";
}

/// The home at the start, with what each of the problem's names stands for, as BehaviorTask reads it: the name of an
/// object, of a substance or of the robot.
std::string sampled_scene(const BddlProblem& problem, const ExportedScene& scene) {
  Json instances = Json::object();
  for (const auto& [id, name] : problem.names) {
    if (id.find('/') == std::string::npos) instances[name] = scene.names.at(id);
  }
  for (const auto& [substance, name] : problem.substances) instances[name] = substance;
  instances[kBddlAgent] = kRobot;
  Json json = Json::parse(scene.text);
  json["metadata"]["task"]["inst_to_name"] = std::move(instances);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// A task as a runner reads it, beside its BDDL problem.
Json task_json(const FinishedTask& task, const BddlProblem& problem, const ExportedScene& scene) {
  Json propositions = Json::array(), plan = Json::array();
  for (const LtlfProposition& one : problem.goal.goal.propositions) {
    propositions.push_back({{"name", one.name},
                            {"predicate", one.predicate},
                            {"arguments", one.arguments},
                            {"bddl", problem.goal.literals.at(one.name)}});
  }
  const auto& steps = task.shown.at(Mode::M1).steps;
  std::size_t moment = 0;
  for (const StepRecord& step : steps) {
    Json arguments = Json::array();
    for (const auto& argument : step.command.args) arguments.push_back(argument.id);
    const auto moments = moments_of_step(problem.goal.holding, moment, step.moments.size());
    Json here{{"action", step.command.action}, {"args", std::move(arguments)}, {"holds", moments.back()}};
    if (moments.size() > 1) here["moments"] = moments;
    plan.push_back(std::move(here));
  }
  return {
      {"format", "unietp-behavior/1"},
      {"task", task.record.id},
      {"template", task.record.template_name},
      {"instruction", task.record.instruction},
      {"objects", problem.names},
      {"substances", problem.substances},
      {"scene_objects", scene.names},
      {"not_said", scene.left_out},
      {"agent",
       {{"position", {task.start.agent.position.x(), task.start.agent.position.y()}}, {"yaw", task.start.agent.yaw}}},
      {"last_state_decides", problem.decides},
      {"goal",
       {{"text", task.record.goal_text},
        {"formula", problem.goal.goal.formula},
        {"propositions", std::move(propositions)},
        {"holds", problem.goal.holding.front()}}},
      {"plan", std::move(plan)}};
}

Result<std::vector<AssetFile>> activity_files(const FinishedTask& task, const BddlProblem& problem,
                                              const Knowledge& knowledge) {
  const auto scene = write_behavior(task.start, knowledge);
  if (!scene) return scene.error();
  const std::string& id = task.record.id;
  std::string text = task_json(task, problem, *scene).dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
  return std::vector<AssetFile>{
      {"activity_definitions/" + id + "/problem0.bddl", problem.text},
      {"scenes/" + id + "/json/" + id + "_task_" + id + "_0_0_template.json", sampled_scene(problem, *scene)},
      {id + ".json", std::move(text)}};
}

/// For each task of BEHAVIOR `activity_definitions/<task>/problem0.bddl`, the folder that the package `bddl` reads
/// activities from; its start where OmniGibson looks for sampled scenes; and `<task>.json` with the exact goal over
/// literals of BDDL; and left_out.jsonl.
Result<ExportSummary> write_behavior_files(const ExportRequest& request) {
  return write_expressed(request, express_behavior(request));
}

}  // namespace

Result<ExpressTask> express_behavior(const ExportRequest& request) {
  auto words = read_bddl_words(request.data / "bddl");
  if (!words) return words.error();
  auto abilities = read_behavior_abilities(request.data / "bddl" / "abilities.csv");
  if (!abilities) return abilities.error();
  return ExpressTask([words = std::move(*words), abilities = std::move(*abilities),
                      &request](const FinishedTask& task) -> Result<ExpressedTask> {
    const Knowledge& knowledge = *backend_of(request.backends, task.start).knowledge;
    auto problem = bddl_problem(task, knowledge, words);
    if (!problem) return ExpressedTask{problem.error().message, nullptr};
    if (const auto lacking = without_model(task, *problem, knowledge); !lacking.empty())
      return ExpressedTask{"no model of " + lacking + " is known", nullptr};
    auto why = denied_by_omnigibson(task, problem->goal.goal, words.categories, abilities);
    if (why.empty()) why = beyond_own_simulator(task);
    if (!why.empty()) return ExpressedTask{std::move(why), nullptr};
    return ExpressedTask{
        "", [&task, &knowledge, problem = std::move(*problem)] { return activity_files(task, problem, knowledge); }};
  });
}

ExportFormat behavior_format() {
  return {"behavior",         "BEHAVIOR's activities, and goals over time", {}, true, write_behavior_files, true,
          Simulator::Behavior};
}

}  // namespace unietp
