#pragma once

#include <optional>

#include "simulation/portrait.h"

namespace unietp {

/// How far two pictures of one thing are apart, over the pixels that show it in either. The light, the place and all
/// else are the same.
struct Contrast {
  double mean = 0;   // of 255, over the three colors
  double clear = 0;  // share of the pixels that differ by at least kClearDifference
};
inline constexpr double kClearDifference = 24;  // of 255
/// Two looks of a thing are told apart by a mean of 6 of 255, or where a twentieth of its pixels differ clearly.
inline constexpr double kLeastMean = 6, kLeastClear = 0.05;
inline bool distinguishable(const Contrast& contrast) {
  return contrast.mean >= kLeastMean || contrast.clear >= kLeastClear;
}

/// Of two things of one size and shape, by portraits of 64 x 64 pixels. Deterministic; about 2 ms.
Contrast contrast_of(const Node& one, const Node& other, Simulator simulator);

/// The first thing with the color, the material or the state, or the other states of its group, that another one has
/// instead. nullopt for predicates that are not of a thing's body, and when both have the same.
std::optional<Node> with_look_of(const Node& one, const Node& other, Predicate predicate);

}  // namespace unietp
