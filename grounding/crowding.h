#pragma once

#include <cstddef>
#include <string>

#include "grounding/workspace.h"

namespace unietp {

// What a start changes without need catches nobody's eye. Without a household everything may be.

/// Whether a home that has so many of a category may come to have that many more: three kettles are odd, three forks
/// are not.
bool may_be_so_many(const Workspace& workspace, std::size_t number, std::size_t more, const std::string& category);

/// Whether so many things of a category that were changed alike are enough.
bool is_enough(const Workspace& workspace, const std::string& category, int changed);

/// Whether another thing of a category may come to a place of a workspace that began as a home, as last read: no crowd
/// of things comes to it, no row of one kind, and nothing to a dish that holds something else. `together`: how many of
/// what the task needs came to one place; as many others may.
bool has_room_for(const Workspace& workspace, const std::string& category, const Node& host, int together);

/// Whether other things may be in a state as well. How warm things are follows from where they are; nothing is left
/// running, broken or cut up for no reason.
bool may_be_common(const State& state);

}  // namespace unietp
