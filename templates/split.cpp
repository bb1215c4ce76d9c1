#include <array>

#include "templates/template.h"
#include "templates/word_meanings.h"

namespace unietp {
namespace {

constexpr std::array<WordMeaning, 5> kSplits = {{
    {"atomic", "one condition on one object"},
    {"compositional", "several conditions, together or one after the other"},
    {"logical", "counts, quantifiers, alternatives, conditions, order, and prohibitions"},
    {"instance_grounding", "the objects must be told apart from others of their category: the dirty mug"},
    {"linguistic", "the same goal in other words: a synonym, the use of an object, a need that implies it"},
}};
static_assert(kSplits.size() == static_cast<std::size_t>(Split::Linguistic) + 1);

}  // namespace

std::span<const WordMeaning> split_meanings() { return kSplits; }

std::string_view name_of(Split split) { return kSplits.at(static_cast<std::size_t>(split)).word; }

std::optional<Split> split_named(std::string_view name) {
  for (std::size_t i = 0; i < kSplits.size(); ++i) {
    if (kSplits.at(i).word == name) return static_cast<Split>(i);
  }
  return std::nullopt;
}

}  // namespace unietp
