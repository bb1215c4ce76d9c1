#include "generator/style.h"

#include <algorithm>
#include <array>

namespace unietp {
namespace {

constexpr std::array<std::string_view, kStyleCount> kStyleNames{
    "direct",         "alias",           "function",       "context",       "distractor",
    "negation",       "relative-clause", "inverted-order", "coreference",   "implicit-need",
    "vague-quantity", "background",      "bystander",      "nested-syntax", "condition"};

}  // namespace

std::string_view name_of(Style style) { return kStyleNames[static_cast<std::size_t>(style)]; }

std::optional<Style> style_named(std::string_view name) {
  const auto found = std::find(kStyleNames.begin(), kStyleNames.end(), name);
  if (found == kStyleNames.end()) return std::nullopt;
  return static_cast<Style>(found - kStyleNames.begin());
}

}  // namespace unietp
