#pragma once

#include "akb/knowledge.h"
#include "scene/scene.h"
#include "simulation/profile.h"
#include "simulation/relations.h"
#include "tests/support/kitchen_knowledge.h"

namespace unietp::testing {

/// A 5 x 4 m kitchen with a table, a counter, a fridge, a microwave on the counter, a sink, a chest of drawers, and on
/// the table a mug, an apple, a knife and a plate: what the tests of physics and actions need, built by hand.
Scene kitchen();
Profile kitchen_profile(Simulator simulator = Simulator::Ai2thor, ActionProfile actions = ActionProfile::Unietp);

/// The same kitchen as another simulator has it, with a stove, and on the counter a towel, a bottle of ketchup, a
/// bottle of wine and a bar of soap: what the actions on contents need.
Scene full_kitchen(Simulator simulator);

/// The full kitchen with a sofa, a lamp with a plug on the chest of drawers, and on the table a bulb for it: what the
/// actions of the profile `wide` need.
Scene wide_kitchen(Simulator simulator);

/// Adds a movable resting at (x, y) with its lowest side at z.
Node& add(Scene& scene, const std::string& id, const Knowledge& knowledge, const std::string& category, double x,
          double y, double z, double yaw = 0);

}  // namespace unietp::testing
