#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "akb/knowledge.h"
#include "dataset/balance.h"
#include "generator/style.h"
#include "generator/weighted_binding.h"

namespace unietp {

/// Of a text in a style that calls things by what they are for ("something to drink from"): the narrowest kind of each
/// bound thing that has such words, as traits of `Dimension::Use`, sorted. None for other styles.
std::vector<Trait> uses_of(const Template& source, const Binding& binding, std::optional<Style> style,
                           const Knowledge& knowledge);

/// Whose uses are counted, and which part of all kinds comes first: blocks do not know of one another, so each prefers
/// another part, `part` of kUseParts by the seed.
struct UseWishes {
  std::optional<Style> style;
  std::uint64_t seed = 0;
  int part = 0;
};
inline constexpr int kUseParts = 4;

/// `plain`, but things whose kind has been called by its use, in the style asked for, come after those of other kinds.
/// Nothing changes for styles that call nothing so. All but `wishes` must outlive it.
CategoryWeight with_new_uses(CategoryWeight plain, const UseWishes& wishes, const Template& source,
                             const Knowledge& knowledge, const Frequencies& counts);

}  // namespace unietp
