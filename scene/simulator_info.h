#pragma once

#include <span>
#include <string_view>

#include "logic/vocabulary.h"
#include "scene/simulator.h"

namespace unietp {

/// What tells one simulator from another in code: a row of scene/simulator_info.cpp. The numbers of its agent are in
/// data/simulators/, its actions in scene/action_table.cpp.
struct SimulatorInfo {
  Simulator simulator;
  std::string_view name;             // "ai2thor", as in files and options
  std::string_view title;            // "AI2-THOR", as its authors write it
  bool all_states;                   // goals may name every state
  std::span<const Predicate> shows;  // otherwise these, which tell the others of their groups
  bool attaches;                     // in the profile `wide`, things placed on others can be attached to them
};
/// The row of a simulator. Every simulator has one.
const SimulatorInfo& info(Simulator simulator);

}  // namespace unietp
