#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/rng.h"

namespace unietp {

/// A wall between two rooms of a plan, long enough for an opening.
struct SharedWall {
  std::size_t a = 0, b = 0;  // rooms
  int axis = 0;              // the wall runs along this axis
  double at = 0;             // coordinate on the other axis, m
  double from = 0, to = 0;   // along the wall, m
};

/// Which rooms have openings to which, by pairs of room types.
struct RoomDoors {
  using Pairs = std::vector<std::pair<std::string, std::string>>;
  Pairs walked_through;  // rooms that one walks through, all joined with one another; pairs that are joined first
  Pairs at_the_end;      // a room that nobody walks through, and where its only door leads: the first that there is
  Pairs another;         // pairs that may have an opening more
};
/// Reads room_doors.csv (use,room,other,source) with the uses `walked_through`, `at_the_end` and `another`. Errors are
/// appended: Parse; Schema for an unknown use or room type.
RoomDoors read_room_doors(std::string_view where, std::string_view text, std::vector<Error>& errors);

/// Which of the shared walls get an opening, so that every room hangs together with the others as homes are built:
/// - rooms that one walks through (corridor, living rooms, dining room) are joined with one another; every room at the
///   end has a door to one of them: a kitchen by a dining or living room, a bedroom by a corridor or living room;
/// - a bathroom opens from the corridor, or from a bedroom of its own; in a home with a corridor at least one does so;
/// - a few more, of the pairs in `another`.
/// nullopt when the walls do not allow it. Deterministic in rng.
std::optional<std::vector<SharedWall>> choose_openings(const std::vector<std::string>& room_types,
                                                       std::vector<SharedWall> walls, const RoomDoors& doors, Rng& rng);

/// How many bathrooms a home may have for its bedrooms: one for every three, at most one each, at most three.
bool bathrooms_suit(int bathrooms, int bedrooms);

}  // namespace unietp
