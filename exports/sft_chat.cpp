#include "exports/sft_chat.h"

#include <optional>

#include <nlohmann/json.hpp>

#include "exports/sft_reasoning.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

std::string seen_words(const StepRecord& step) {
  if (step.visible.empty()) return "Nothing is in view.";
  std::string text = "In view:";
  for (const VisibleObject& object : step.visible) {
    text += text.back() == ':' ? " " : "; ";
    text += object.id + " " + Json(object.box).dump();
  }
  return text + ".";
}

std::string became_words(const StepRecord& step) { return step.success ? "succeeded" : "failed. " + step.feedback; }

}  // namespace

SftChat chat_of(const FinishedTask& task, Mode mode, const ValidationBackend& backend, bool boxes, bool reasoning) {
  SftChat chat{system_prompt(task.start, mode, *backend.profile, reasoning), "Task: " + task.record.instruction, {}};
  std::optional<SftReasoning> thoughts;
  if (reasoning) thoughts.emplace(task, mode, *backend.knowledge);
  Scene scene = task.start;
  const auto& steps = task.shown.at(mode).steps;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const StepRecord& step = steps[i];
    SftTurn turn;
    if (i > 0) turn.outcome = "The last action " + became_words(steps[i - 1]) + (steps[i - 1].success ? "." : "");
    turn.happened = to_text(step.command) + ": " + became_words(step);
    if (boxes) turn.seen = seen_words(step);
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
