#pragma once

#include <optional>
#include <vector>

#include "expert/attempt.h"

namespace unietp {

/// What decides among orders; further preferences are tried when the usual ones fail.
struct OrderPreferences {
  bool far_first = false;              // else the nearest object first
  bool switch_before_placing = false;  // open or switch on a movable thing before it is put down, not after
  bool large_first = false;            // what takes up most room, however far
};

/// Which of the literals that do not hold yet to bring about next; nullopt when all hold. Cutting comes first, then
/// clearing away, then one movable object after the other (states in hand, then its place; contents before what carries
/// them), then fixed doors and switches, then what is to stay in hand, closing and switching on last. Distances decide
/// between equals.
std::optional<Literal> next_literal(const Attempt& attempt, const std::vector<Literal>& literals,
                                    const OrderPreferences& preferences);

/// An order of an alternative's moments that respects their arrows.
std::vector<std::size_t> order_of_moments(const Alternative& alternative, const OrderPreferences& preferences);

}  // namespace unietp
