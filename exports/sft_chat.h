#pragma once

#include <string>
#include <vector>

#include "exports/finished_tasks.h"
#include "scene/action.h"

namespace unietp {

/// How a turn tells what is in view: by the picture alone, with boxes beside it, or in words alone.
enum class SftView { Picture, Boxes, Words };

/// One step of a conversation: the observation before it and the answer.
struct SftTurn {
  std::string outcome;         // result of the previous action; "" before the first
  std::string happened;        // this step with its outcome, for the history of later ones: "pick_up(mug_1): succeeded"
  std::string seen;            // what is in view, as text; "" when only pictures are shown
  std::string answer;          // the action as JSON
  bool worth_learning = true;  // the action succeeded
  Scene before;                // the picture's
};

/// A demonstration as a conversation.
struct SftChat {
  std::string system, task;
  std::vector<SftTurn> turns;
};

/// The task must have a demonstration of `mode`. The texts are those of an environment and of an evaluation with the
/// same view. Deterministic.
SftChat chat_of(const FinishedTask& task, Mode mode, const ValidationBackend& backend, SftView view, bool reasoning);

}  // namespace unietp
