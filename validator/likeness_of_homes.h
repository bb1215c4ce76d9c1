#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace unietp {

/// What a home looks like: the pairs of things that are near each other in one room, each by what the two are and by
/// how far they are apart. A room counts as a thing at its middle. Nothing of it depends on what the home, its rooms
/// and its objects are called, on their order, or on where the home lies, how it is turned and whether it is mirrored.
/// One number per pair: what the two are in the high bits, the distance in millimeters in the low ones; sorted.
struct HomeFingerprint {
  std::vector<std::uint64_t> by_category;  // what a thing is: its category
  std::vector<std::uint64_t> by_size;      // its size, to the centimeter: finds a home whose categories were renamed
};

/// Some 17 KB for a home of 200 objects. Time: quadratic in the objects of one room.
HomeFingerprint print_of_home(const Scene& home);

/// How much of the smaller of two homes is also in the other: the share of its pairs that have a pair of their own
/// there of the same things, whose distance differs by at most 5 cm. By category or by size, whichever is more. From 0
/// to 1, and symmetric.
double likeness_of_homes(const HomeFingerprint& a, const HomeFingerprint& b);

}  // namespace unietp
