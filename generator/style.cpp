#include "generator/style.h"

#include <algorithm>
#include <array>

namespace unietp {
namespace {

constexpr std::array<std::string_view, kStyleCount> kStyleNames{
    "direct",         "alias",       "function",      "hypernym",       "description",
    "context",        "request",     "aside",         "exception",      "ellipsis",
    "anaphora",       "compound",    "distractor",    "negation",       "subordinate-clause",
    "inverted-order", "coreference", "implicit-need", "vague-quantity", "condition"};

}  // namespace

std::string_view name_of(Style style) { return kStyleNames[static_cast<std::size_t>(style)]; }

std::optional<Style> style_named(std::string_view name) {
  const auto found = std::find(kStyleNames.begin(), kStyleNames.end(), name);
  if (found == kStyleNames.end()) return std::nullopt;
  return static_cast<Style>(found - kStyleNames.begin());
}

bool names_by_phrase(Style style) {
  return style == Style::Function || style == Style::Hypernym || style == Style::Description ||
         style == Style::Context || style == Style::Request;
}

}  // namespace unietp
