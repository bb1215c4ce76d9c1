#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "logic/vocabulary.h"
#include "scene/simulator.h"

namespace unietp {

// The words of the release by the paper's authors (woyut/UniETP, commit b48647a7, its scene graphs and data loader).

/// "THOR.json": the file that their runner reads a simulator's tasks from.
std::string_view release_file(Simulator simulator);

/// The name of a state that their scene graph of this simulator really fills, or nullopt.
std::optional<std::string_view> release_state(Simulator simulator, Predicate predicate);

/// A room's category in their scene graph, by our type of room; nullopt where that is not known.
std::optional<std::string> release_room(Simulator simulator, std::string_view type);

/// Whether their graph of this simulator has `on` and `inside` side by side; otherwise the receptacle's category
/// decides which of the two is said.
bool says_on_and_inside(Simulator simulator);
/// Whether it says for every object in which room it is.
bool says_rooms_of_objects(Simulator simulator);

}  // namespace unietp
