#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "scene/simulator.h"

namespace unietp {

/// A form of tasks that a simulator loads, by the name of the export that writes it.
struct SimulatorForm {
  enum class Kind : std::uint8_t { Ai2thor, Virtualhome, VirtualhomeUnity, Habitat, Behavior };
  Kind kind;
  std::string_view name;
  Simulator simulator;
};

/// All of them, those of a simulator next to each other; the last one is the strictest.
inline constexpr std::array kSimulatorForms{
    SimulatorForm{SimulatorForm::Kind::Ai2thor, "ai2thor", Simulator::Ai2thor},
    SimulatorForm{SimulatorForm::Kind::Virtualhome, "virtualhome", Simulator::Virtualhome},
    SimulatorForm{SimulatorForm::Kind::VirtualhomeUnity, "virtualhome-unity", Simulator::Virtualhome},
    SimulatorForm{SimulatorForm::Kind::Habitat, "habitat", Simulator::Habitat},
    SimulatorForm{SimulatorForm::Kind::Behavior, "behavior", Simulator::Behavior}};

}  // namespace unietp
