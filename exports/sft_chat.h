#pragma once

#include <string>
#include <vector>

#include "exports/finished_tasks.h"
#include "scene/action.h"

namespace unietp {

/// One exchange: what the agent is told before a step, and the step.
struct SftTurn {
  std::string outcome;         // of the action before; "" before the first
  std::string happened;        // this step with its outcome, for the history of later ones: "pick_up(mug_1): succeeded"
  std::string seen;            // boxes in words; "" when only pictures are shown
  std::string answer;          // the action as JSON
  bool worth_learning = true;  // the action succeeded
  Scene before;                // the picture's
};

/// A demonstration as a conversation.
struct SftChat {
  std::string system, task;
  std::vector<SftTurn> turns;
};

/// Deterministic. The demonstration of `mode` must be there. `boxes`: say what is in view in words.
SftChat chat_of(const FinishedTask& task, Mode mode, const ValidationBackend& backend, bool boxes, bool reasoning);

/// What an agent of a mode is told before it begins: its actions with what each needs, how to answer, and what it knows
/// of the home.
std::string system_prompt(const Scene& start, Mode mode, const Profile& profile, bool reasoning);

}  // namespace unietp
