#pragma once

#include <span>
#include <string_view>

namespace unietp {

/// What a category with an affordance can have done to it, or can do.
struct AffordanceMeaning {
  std::string_view name, says;
};
/// In the order of affordance_names().
std::span<const AffordanceMeaning> affordance_meanings();

}  // namespace unietp
