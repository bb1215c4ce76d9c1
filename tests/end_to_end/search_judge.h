#pragma once

#include <cstddef>
#include <vector>

#include "environment/task.h"
#include "scene/scene.h"
#include "simulation/mode_rules.h"

namespace unietp {

/// A demonstration in M2 or M3, as somebody judges it who knows what was told and shown up to each moment, and no more.
struct JudgedSearch {
  /// Steps done when all that the goal needs had been seen or told: as many things of each kind as the goal asks for,
  /// one of the tools for each state that it wants, and each thing that the steps from there on act on, but for those
  /// that are search; seen where more is done with it than to go there. The number of all steps where that never is so.
  std::size_t enough = 0;
  /// Steps from there on that are marked as search, but for those that lead to what is used next.
  std::vector<std::size_t> late;
  std::vector<std::size_t> needless;  // those of them without which the rest reaches the goal by the rules of the mode
};

/// `told`: what the expert knew at the start. `views`: what it was shown before each action, and `done`: what it did,
/// on the ids of the home. `search`: which of these actions are marked so.
JudgedSearch judged_search(const EnvironmentTask& task, Mode mode, const Scene& told,
                           const std::vector<std::vector<Node>>& views, const std::vector<Action>& done,
                           const std::vector<bool>& search);

/// Whether the goal speaks of all things of a kind, so that it never is certain that none was overlooked.
bool speaks_of_every(const Formula& goal);

}  // namespace unietp
