#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "logic/vocabulary.h"
#include "scene/action.h"

namespace unietp {

/// What tools do to things, as the effect tables of the knowledge base name it.
enum class Treatment : std::uint8_t {
  Heats,
  Cools,
  Freezes,
  Cooks,
  Burns,
  Washes,
  Soaks,
  Fills,
  Slices,
  Wipes,
  Dispenses,
  Drains,
  Attaches,
};
/// Number of treatments.
inline constexpr std::size_t kTreatments = static_cast<std::size_t>(Treatment::Attaches) + 1;

/// One row of the table of treatments.
struct TreatmentInfo {
  Treatment treatment;
  std::string_view name;              // "heats"
  std::optional<ActionType> treats;   // the action that treats what is held with the tool
  std::optional<ActionType> by_hand;  // the action that uses the held tool on something
  std::span<const Predicate> states;  // what a thing becomes that lies in or on the tool; empty where none does
};
/// The row of a treatment.
const TreatmentInfo& info(Treatment treatment);
/// In the order of the enum.
std::span<const TreatmentInfo> all_treatments();
std::string_view name_of(Treatment treatment);
std::optional<Treatment> treatment_named(std::string_view name);

/// The states that a treatment sets; empty for treatments that do not happen by lying in or on a tool.
std::span<const Predicate> sets(Treatment treatment);
/// The action that treats the held thing with a tool; nullopt where there is none.
std::optional<ActionType> action_for(Treatment treatment);

}  // namespace unietp
