#pragma once

#include <array>
#include <string_view>

#include "scene/simulator.h"

namespace unietp {

/// A form of tasks that a simulator loads, by the name of the export that writes it.
struct SimulatorForm {
  std::string_view name;
  Simulator simulator;
};

/// All of them, those of a simulator next to each other; the last one is the strictest.
inline constexpr std::array kSimulatorForms{
    SimulatorForm{"ai2thor", Simulator::Ai2thor}, SimulatorForm{"virtualhome", Simulator::Virtualhome},
    SimulatorForm{"virtualhome-unity", Simulator::Virtualhome}, SimulatorForm{"habitat", Simulator::Habitat},
    SimulatorForm{"behavior", Simulator::Behavior}};

}  // namespace unietp
