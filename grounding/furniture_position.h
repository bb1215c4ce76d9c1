#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace unietp {

/// Where a piece of furniture goes; the text form of FurnitureRule::where.
struct FurniturePosition {
  enum class Kind {
    Wall,       // back to a wall
    Run,        // back to a wall, in one row with the room's other such pieces, which begins in a corner
    Corner,     // back to a wall, side to another
    Center,     // free in the room
    WallHung,   // on a wall; `wall-hung:0.5` with its lower edge 0.5 m over the floor
    OuterWall,  // likewise, on a wall with no room behind it
    Ceiling,    // hangs from the ceiling, near the room's middle
    On,         // `on:CounterTop`: on top of that furniture, same front
    At,         // `at:DiningTable`: standing around it, facing it
    Beside,     // `beside:Bed`: next to it along the wall; `beside:Sink:1.2` hung there, 1.2 m over the floor
    Before,     // `before:Sofa`: an arm's length in front of it
    Facing,     // `facing:Sofa`: at the wall that it looks at, in its middle; `facing:Sofa:0.95` hung there
    Above,      // `above:Sink:0.02`: over its back edge, that much higher
  };
  Kind kind = Kind::Wall;
  std::string host;                // category, of On, At, Beside, Before, Facing, Above
  std::optional<double> height_m;  // of WallHung, OuterWall, Facing, Beside and Above
};
/// nullopt when the text is none of these.
std::optional<FurniturePosition> parse_furniture_position(std::string_view text);

}  // namespace unietp
