#include "scene/archetype.h"

#include <array>

namespace unietp {
namespace {

constexpr std::array kArchetypes{
    Archetype::Block,   Archetype::Table,    Archetype::Seat,   Archetype::Bed,   Archetype::Shelf,
    Archetype::Cabinet, Archetype::Drawers,  Archetype::Basin,  Archetype::Panel, Archetype::Fixture,
    Archetype::Box,     Archetype::Cylinder, Archetype::Sphere, Archetype::Plate, Archetype::Vessel,
    Archetype::Lidded,  Archetype::Folding,
};

constexpr std::array<std::string_view, kArchetypes.size()> kNames{
    "block",   "table", "seat",     "bed",    "shelf", "cabinet", "drawers", "basin",   "panel",
    "fixture", "box",   "cylinder", "sphere", "plate", "vessel",  "lidded",  "folding",
};

}  // namespace

std::string_view name_of(Archetype archetype) {
  const auto index = static_cast<std::size_t>(archetype);
  return index < kNames.size() ? kNames[index] : std::string_view();
}

std::optional<Archetype> archetype_named(std::string_view name) {
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (kNames[i] == name) return kArchetypes[i];
  }
  return std::nullopt;
}

std::span<const Archetype> all_archetypes() { return kArchetypes; }

}  // namespace unietp
