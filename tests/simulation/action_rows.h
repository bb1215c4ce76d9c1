#pragma once

#include <functional>
#include <string>
#include <vector>

#include "simulation/world.h"

namespace unietp::testing {

/// One row of the table action x simulator: a start in which the action succeeds, or in which one need is not met.
struct ActionRow {
  ActionType action = ActionType::Stop;
  Failure failure = Failure::None;                     // what the step must give; None: it succeeds
  std::string target;                                  // "" for actions without an argument
  std::vector<Action> before;                          // all succeed
  std::function<void(Scene&)> alter = nullptr;         // of the scene that they lead to
  std::function<bool(const Scene&)> effect = nullptr;  // of a success
};

/// Rows for every action of the catalog in the wide kitchen.
std::vector<ActionRow> action_rows();

}  // namespace unietp::testing
