#include "scene/simulator.h"

namespace unietp {

std::string_view name_of(Simulator simulator) {
  switch (simulator) {
    case Simulator::Ai2thor:
      return "ai2thor";
    case Simulator::Virtualhome:
      return "virtualhome";
    case Simulator::Habitat:
      return "habitat";
    case Simulator::Behavior:
      return "behavior";
  }
  return "";
}

std::optional<Simulator> simulator_named(std::string_view name) {
  for (const Simulator simulator : kSimulators) {
    if (name_of(simulator) == name) return simulator;
  }
  return std::nullopt;
}

}  // namespace unietp
