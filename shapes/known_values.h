#pragma once

#include <array>
#include <string_view>

namespace unietp {

/// What every family knows of its object, before its own parameters: width, depth and height of the family's box (after
/// its axes) and the thickness of a hollow's wall, in meters.
inline constexpr std::array<std::string_view, 4> kKnownValues{"w", "d", "h", "wall"};
/// The object's own color, darker, and lighter.
inline constexpr std::array<std::string_view, 3> kRelativeColors{"main", "dark", "light"};

}  // namespace unietp
