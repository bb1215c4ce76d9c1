#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace unietp {

/// How a goal refers to its objects besides their category (templates/refinement_kinds.h).
enum class Referring : std::uint8_t {
  None,     // the goal names its objects only by category
  Written,  // the template has a :where of its own
  ByState,
  ByRelation,
  ByRoom,
  ByNearness,
  BySize,
  ByAttribute,
  ByTwo,       // two of the above together
  EachItsOwn,  // two placeholders of one category, each with a reference of its own
};
inline constexpr std::size_t kReferringCount = static_cast<std::size_t>(Referring::EachItsOwn) + 1;

std::string_view name_of(Referring kind);  // "by-state"; "" for None
/// nullopt for an unknown name.
std::optional<Referring> referring_named(std::string_view name);

}  // namespace unietp
