#pragma once

#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "scene/scene.h"

namespace unietp::testing {

// What the homes that tests build by hand have in common (tests/simulation/kitchen.h, tests/expert/house.h).

/// "curated", certain.
Source curated();

/// A category whose display is its name in words: "WineBottle" is a "wine bottle".
Category category(std::string name, bool movable, Archetype archetype, Vec3 size, double mass);

/// What Fridge, Knife, Microwave and Sink do to Apple, Mug, Plate and Potato.
std::vector<Effect> appliance_effects();

/// A thing of a category in its default states, resting at (x, y) with its lowest side at z.
Node node_of(const Knowledge& knowledge, const std::string& id, const std::string& category, double x, double y,
             double z, double yaw = 0);

}  // namespace unietp::testing
