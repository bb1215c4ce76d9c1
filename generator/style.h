#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace unietp {

/// How an instruction is worded: plainly, or in one of the linguistic refinements (templates/refinement_kinds.h).
enum class Style : std::uint8_t {
  Direct,
  Alias,
  Function,
  Context,
  Distractor,
  Negation,
  RelativeClause,
  InvertedOrder,
  Coreference,
  ImplicitNeed,
  VagueQuantity,
  Background,
  Bystander,
  NestedSyntax,
  Condition,
};
inline constexpr std::size_t kStyleCount = static_cast<std::size_t>(Style::Condition) + 1;

std::string_view name_of(Style style);  // "relative-clause"
/// nullopt for an unknown name.
std::optional<Style> style_named(std::string_view name);

}  // namespace unietp
