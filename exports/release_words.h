#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "interchange/format_facts.h"
#include "logic/vocabulary.h"
#include "scene/simulator.h"

namespace unietp {

// The vocabulary of the release by the paper's authors (woyut/UniETP, commit b48647a7: scene graphs and data loader).

/// "THOR.json": the file that their runner reads a simulator's tasks from.
std::string_view release_file(Simulator simulator);

/// The name of a state that their scene graph of this simulator sets, or nullopt.
std::optional<std::string_view> release_state(Simulator simulator, Predicate predicate);

/// A room's category in their scene graph, by our room type; nullopt when unknown.
std::optional<std::string> release_room(Simulator simulator, std::string_view type, const FormatFacts& facts);

/// Whether their graph of this simulator has both `on` and `inside`; otherwise the receptacle's category decides which
/// of the two it has.
bool says_on_and_inside(Simulator simulator);
/// Whether their graph has the room of every object.
bool says_rooms_of_objects(Simulator simulator);

}  // namespace unietp
