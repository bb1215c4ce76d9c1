#pragma once

#include <optional>
#include <string>

#include "interchange/source_scene.h"

namespace unietp {

// Ids of objects and rooms that were imported with ImportOptions::own_ids. Our own ids, "mug_3", are none of these.

/// The id of a node for an object of a simulator's file: AI2-THOR's objectId, "Mug|surface|2|3"; the name in
/// OmniGibson's scene, "mug_ppzttc_0"; habitat-sim's handle, "frl_apartment_cup_:0003"; VirtualHome numbers its nodes,
/// "mug.193". "" where the simulator has none, as for objects of a table of boxes.
std::string simulators_id(const SourceObject& object, Simulator simulator, const std::string& category);

/// The id that the simulator has for a node of its scene: the inverse. nullopt for a node that is not of its scene.
std::optional<std::string> own_id_of(const Node& node, Simulator simulator);

/// The id of a room that a file numbers, behind its type, which agents need to know: "kitchen|2" for "room|2" of a
/// house of ProcTHOR's, "bathroom.11" for node 11 of VirtualHome's. "" for others: OmniGibson's names, "kitchen_0", and
/// the regions of Habitat's scenes are ids already, and floor plans of iTHOR and scene instances have no rooms.
std::string simulators_room_id(const std::string& type, const std::string& in_file, Simulator simulator);

/// The id that the file of AI2-THOR or VirtualHome has for such a room, "room|2" or "11": the inverse. nullopt for
/// others.
std::optional<std::string> own_id_of(const Room& room, Simulator simulator);

}  // namespace unietp
