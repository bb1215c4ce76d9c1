#include "exports/sft_chat.h"

#include <optional>

#include <nlohmann/json.hpp>

#include "environment/agent_text.h"
#include "environment/floor_plan.h"
#include "environment/picture_text.h"
#include "exports/sft_reasoning.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

SftChat chat_of(const FinishedTask& task, Mode mode, const ValidationBackend& backend, SftView view, bool reasoning) {
  const Settings settings = settings_for(mode);
  SftChat chat{
      system_prompt(task.start, settings, *backend.profile, reasoning), task_text(task.record.instruction), {}};
  std::optional<SftReasoning> thoughts;
  if (reasoning) thoughts.emplace(task, mode, *backend.knowledge);
  Scene scene = task.start;
  const auto& steps = task.shown.at(mode).steps;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const StepRecord& step = steps[i];
    SftTurn turn;
    if (i > 0) turn.outcome = outcome_text(steps[i - 1].success, steps[i - 1].feedback);
    turn.happened = history_text(to_text(step.command), step.success, step.feedback);
    if (view != SftView::Picture) turn.seen = view_text(step.visible);
    if (view == SftView::Words) {
      const std::string shown = picture_text(scene, step.visible);
      turn.seen += (shown.empty() ? "" : "\n") + shown;
    }
    if (settings.floor_plan) turn.seen = pose_text(own_pose(scene.agent)) + (turn.seen.empty() ? "" : "\n") + turn.seen;
    Json answer = Json::object();
    if (thoughts) answer["reasoning"] = thoughts->before_step(i, scene);
    answer.update(command_to_json(step.command));
    turn.answer = answer.dump();
    turn.worth_learning = step.success;
    turn.before = scene;
    chat.turns.push_back(std::move(turn));
    scene = apply(std::move(scene), step.changes);
  }
  return chat;
}

}  // namespace unietp
