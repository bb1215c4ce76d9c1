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

/// How much categories are wanted for a template's tasks of a split in a home: those of which it has enough far before
/// those of which some would have to be added, furniture that it has once before such as it has often, and of these the
/// ones that were used less, as were the rooms in which they are. `rooms` may be null. All must outlive it.
CategoryWeight weight_in(const Layout& layout, const Template& source, Split split, const Frequencies& counts,
                         const RoomTypes* rooms);

}  // namespace unietp
