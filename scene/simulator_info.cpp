#include "scene/simulator_info.h"

#include <array>
#include <cstddef>

namespace unietp {
namespace {

constexpr std::array kOpen{Predicate::Open};
constexpr std::array kOpenAndOn{Predicate::Open, Predicate::PowerOn};

constexpr std::array<SimulatorInfo, kSimulators.size()> kInfos{{
    {Simulator::Ai2thor, "ai2thor", "AI2-THOR", true, {}, false},
    {Simulator::Virtualhome, "virtualhome", "VirtualHome", false, kOpenAndOn, false},
    {Simulator::Habitat, "habitat", "Habitat", false, kOpen, false},
    {Simulator::Behavior, "behavior", "BEHAVIOR", true, {}, true},
}};

constexpr bool in_their_order() {
  for (std::size_t i = 0; i < kSimulators.size(); ++i) {
    if (kInfos[i].simulator != kSimulators[i] || static_cast<std::size_t>(kSimulators[i]) != i) return false;
  }
  return true;
}
static_assert(in_their_order());

}  // namespace

const SimulatorInfo& info(Simulator simulator) { return kInfos[static_cast<std::size_t>(simulator)]; }

std::string_view name_of(Simulator simulator) { return info(simulator).name; }

std::optional<Simulator> simulator_named(std::string_view name) {
  for (const SimulatorInfo& row : kInfos) {
    if (row.name == name) return row.simulator;
  }
  return std::nullopt;
}

}  // namespace unietp
