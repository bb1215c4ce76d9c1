#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace unietp {

/// How an instruction is worded: plainly, or with one of the phenomena of language that the Linguistic split is about
/// (templates/refinement_kinds.h).
enum class Style : std::uint8_t {
  Direct,
  Alias,
  Function,
  Hypernym,
  Description,
  Context,
  Request,
  Aside,
  Exception,
  Ellipsis,
  Anaphora,
  Compound,
  Distractor,
  Negation,
  SubordinateClause,
  InvertedOrder,
  Coreference,
  ImplicitNeed,
  VagueQuantity,
  Condition,
};
inline constexpr std::size_t kStyleCount = static_cast<std::size_t>(Style::Condition) + 1;

/// Whether an object is named by a phrase that other categories share, so that the goal accepts all of these.
bool names_by_phrase(Style style);

std::string_view name_of(Style style);  // "subordinate-clause"
/// nullopt for an unknown name.
std::optional<Style> style_named(std::string_view name);

}  // namespace unietp
