#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace unietp {

/// The four simulators that tasks are made for.
enum class Simulator : std::uint8_t { Ai2thor, Virtualhome, Habitat, Behavior };
/// All of them, in the order of the enum, which is the order of tables and reports.
inline constexpr std::array kSimulators{Simulator::Ai2thor, Simulator::Virtualhome, Simulator::Habitat,
                                        Simulator::Behavior};

std::string_view name_of(Simulator simulator);  // "ai2thor", as in files and options
/// nullopt for an unknown name.
std::optional<Simulator> simulator_named(std::string_view name);

}  // namespace unietp
