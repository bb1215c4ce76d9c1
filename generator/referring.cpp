#include "generator/referring.h"

#include <algorithm>
#include <array>

namespace unietp {
namespace {

constexpr std::array<std::string_view, kReferringCount> kReferringNames{
    "",        "referring",    "by-state", "by-relation", "by-room", "by-nearness",
    "by-size", "by-attribute", "by-two",   "each-its-own"};

}  // namespace

std::string_view name_of(Referring kind) { return kReferringNames[static_cast<std::size_t>(kind)]; }

std::optional<Referring> referring_named(std::string_view name) {
  const auto found = std::find(kReferringNames.begin(), kReferringNames.end(), name);
  if (found == kReferringNames.end()) return std::nullopt;
  return static_cast<Referring>(found - kReferringNames.begin());
}

}  // namespace unietp
