#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/rng.h"

namespace unietp {

/// A wall between two rooms of a plan, long enough for an opening.
struct SharedWall {
  std::size_t a = 0, b = 0;  // rooms
  int axis = 0;              // the wall runs along this axis
  double at = 0;             // coordinate on the other axis, m
  double from = 0, to = 0;   // along the wall, m
};

/// Which of the shared walls get an opening, so that every room hangs together with the others as homes are built:
/// - corridor, living rooms and dining room are joined with one another; every other room has a door to one of them,
/// and
///   nobody walks through it: a kitchen by a dining or living room, a bedroom by a corridor or living room, an office
///   by any of the three;
/// - a bathroom opens from the corridor, or from a bedroom of its own; in a home with a corridor at least one does so;
/// - a few more between kitchen, dining room, living rooms and corridor.
/// nullopt when the walls do not allow it. Deterministic in rng.
std::optional<std::vector<SharedWall>> choose_openings(const std::vector<std::string>& room_types,
                                                       std::vector<SharedWall> walls, Rng& rng);

/// How many bathrooms a home may have for its bedrooms: one for every three, at most one each, at most three.
bool bathrooms_suit(int bathrooms, int bedrooms);

}  // namespace unietp
