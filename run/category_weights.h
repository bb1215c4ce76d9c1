#pragma once

#include <map>
#include <string>

#include "dataset/balance.h"
#include "generator/weighted_binding.h"
#include "run/layout_pool.h"

namespace unietp {

/// Category -> the kinds of room of a home that have it, as Frequencies names them -> what share of it.
using RoomTypes = std::map<std::string, std::map<std::string, double>>;
RoomTypes room_types_in(const Layout& layout);

/// How much categories are wanted for a template in a home: those that it has far before those that would have to be
/// added, and of these the ones that were used less, as were the rooms in which they are. `rooms` may be null. All must
/// outlive it.
CategoryWeight weight_in(const Layout& layout, const Template& source, const Frequencies& counts,
                         const RoomTypes* rooms);

}  // namespace unietp
