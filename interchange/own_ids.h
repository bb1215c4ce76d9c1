#pragma once

#include <optional>
#include <string>

#include "interchange/source_scene.h"

namespace unietp {

// Ids of objects that were imported with ImportOptions::own_ids. Our own ids, "mug_3", are none of these.

/// The id of a node for an object of a simulator's file: AI2-THOR's objectId, "Mug|surface|2|3"; the name in
/// OmniGibson's scene, "mug_ppzttc_0"; habitat-sim's handle, "frl_apartment_cup_:0003"; VirtualHome numbers its nodes,
/// "mug.193". "" where the simulator has none, as for objects of a table of boxes.
std::string simulators_id(const SourceObject& object, Simulator simulator, const std::string& category);

/// The id that the simulator has for a node of its scene: the inverse. nullopt for a node that is not of its scene.
std::optional<std::string> own_id_of(const Node& node, Simulator simulator);

}  // namespace unietp
