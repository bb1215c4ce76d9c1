#pragma once

#include <optional>

#include "akb/rows.h"

namespace unietp {

/// The room that one object has at a receptacle, meters: a level rectangle and the free height over it.
struct Room3 {
  double width = 0, depth = 0;
  double clearance = 0;     // free height; large where nothing is above
  bool open_above = false;  // a hollow out of which things may stick
  int levels = 1;           // shelves one above the other
};

/// The rectangle that a category offers for a relation (`on`, `inside` or `under`), or nothing when its archetype has
/// none. Conservative: a shape built with walls of up to 2 cm (1 cm for small things) has at least this much room.
std::optional<Room3> room_of(const Category& receptacle, Predicate relation);

/// True when an upright object, turned about z by a quarter turn at will, finds room with a centimeter to spare in each
/// direction. Out of an open hollow it may stick by its own height at most once.
bool fits(const Vec3& object, const Room3& room);
/// The same for an object of typical size and the room of a receptacle.
bool fits(const Category& object, Predicate relation, const Category& receptacle);

/// True when both stand next to one another on the top of `support`, 2 cm apart, each turned as it likes.
bool fit_side_by_side(const Category& a, const Category& b, const Category& support);

/// True when a scene may give a thing of the category this model's box: along each axis at most 1.15 times the
/// category's, so it goes where the category goes, and at least 0.65 times, 0.9 times where things are put on or in it,
/// so it holds what the category holds. What has no front (movables, tables, rugs, plants) may lie turned a quarter.
bool usable(const Asset& asset, const Category& category);

/// How many such objects fit side by side on all levels with 2 cm between them, at most 12 and six tenths of the full
/// grid (rule `footprint`); 0 when none fits.
int capacity_of(const Category& object, Predicate relation, const Category& receptacle);

}  // namespace unietp
