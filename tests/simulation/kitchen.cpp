#include "tests/simulation/kitchen.h"

#include <numbers>

#include "tests/support/household.h"

namespace unietp::testing {

Knowledge kitchen_knowledge(Simulator simulator) {
  std::vector<Category> categories{
      category("Apple", true, Archetype::Sphere, {0.08, 0.08, 0.08}, 0.2),
      category("AppleSliced", true, Archetype::Box, {0.02, 0.08, 0.08}, 0.05),
      category("Bulb", true, Archetype::Box, {0.05, 0.05, 0.06}, 0.05),
      category("CounterTop", false, Archetype::Block, {1.4, 0.6, 0.9}, 60),
      category("DiningTable", false, Archetype::Table, {1.2, 0.8, 0.75}, 25),
      category("Dresser", false, Archetype::Drawers, {0.8, 0.45, 0.7}, 30),
      category("Fridge", false, Archetype::Cabinet, {0.7, 0.65, 1.7}, 80),
      category("Ketchup", true, Archetype::Cylinder, {0.06, 0.06, 0.16}, 0.5),
      category("Knife", true, Archetype::Box, {0.22, 0.025, 0.02}, 0.1),
      category("Lamp", false, Archetype::Fixture, {0.16, 0.16, 0.3}, 2),
      category("Microwave", false, Archetype::Cabinet, {0.5, 0.36, 0.3}, 12),
      category("Mug", true, Archetype::Vessel, {0.09, 0.09, 0.1}, 0.3),
      category("Plate", true, Archetype::Plate, {0.24, 0.24, 0.02}, 0.4),
      category("Potato", true, Archetype::Box, {0.09, 0.06, 0.06}, 0.2),
      category("Sink", false, Archetype::Basin, {0.6, 0.5, 0.9}, 40),
      category("SoapBar", true, Archetype::Box, {0.08, 0.05, 0.03}, 0.1),
      category("Sofa", false, Archetype::Seat, {1.6, 0.8, 0.8}, 40),
      category("Stove", false, Archetype::Block, {0.6, 0.6, 0.9}, 50),
      category("Towel", true, Archetype::Box, {0.2, 0.15, 0.03}, 0.2),
      category("WineBottle", true, Archetype::Cylinder, {0.08, 0.08, 0.3}, 1.2),
  };
  std::vector<AffordanceFact> affordances;
  const auto affords = [&](const std::string& name, std::initializer_list<const char*> what) {
    for (const char* affordance : what) affordances.push_back({name, affordance, curated()});
  };
  affords("Apple", {"pickupable", "readable", "sliceable"});
  affords("AppleSliced", {"pickupable"});
  affords("Bulb", {"pickupable"});
  affords("CounterTop", {"receptacle"});
  affords("DiningTable", {"receptacle"});
  affords("Dresser", {"container", "openable", "receptacle"});
  affords("Fridge", {"container", "openable", "receptacle"});
  affords("Knife", {"pickupable"});
  affords("Lamp", {"pluggable", "switchable"});
  affords("Microwave", {"container", "openable", "switchable"});
  affords("Ketchup", {"pickupable"});
  affords("Mug", {"breakable", "container", "dirtyable", "fillable", "heatable", "pickupable"});
  affords("Plate", {"dirtyable", "pickupable", "receptacle"});
  affords("Potato", {"burnable", "cookable", "heatable", "pickupable"});
  affords("Sink", {"container", "drain"});
  affords("SoapBar", {"consumable", "pickupable"});
  affords("Sofa", {"lieable", "receptacle", "sittable"});
  affords("Stove", {"receptacle", "switchable"});
  affords("Towel", {"foldable", "pickupable", "soakable"});
  affords("WineBottle", {"fillable", "pickupable"});
  std::vector<Effect> effects = appliance_effects();
  const std::vector<EffectNeed> tap{EffectNeed::Inside, EffectNeed::UnderTap};
  const std::vector<Effect> further{
      {"Ketchup", Treatment::Dispenses, "Plate", "ketchup", 0, {EffectNeed::Held}, curated()},
      {"Lamp", Treatment::Attaches, "Bulb", "", 0, {}, curated()},
      {"Microwave",
       Treatment::Cooks,
       "Potato",
       "",
       0,
       {EffectNeed::Closed, EffectNeed::Inside, EffectNeed::PowerOn},
       curated()},
      {"Sink", Treatment::Fills, "Mug", "water", 0, tap, curated()},
      {"Sink", Treatment::Soaks, "Towel", "water", 0, tap, curated()},
      {"Stove", Treatment::Burns, "Potato", "", 0, {EffectNeed::On, EffectNeed::PowerOn}, curated()},
      {"Towel", Treatment::Wipes, "Plate", "", 0, {EffectNeed::Held}, curated()},
      {"WineBottle", Treatment::Fills, "Mug", "wine", 0, {EffectNeed::Held}, curated()},
  };
  effects.insert(effects.end(), further.begin(), further.end());
  return Knowledge(simulator, std::move(categories), std::move(affordances), {}, std::move(effects), {});
}

Node& add(Scene& scene, const std::string& id, const Knowledge& knowledge, const std::string& name, double x, double y,
          double z, double yaw) {
  return scene.nodes.emplace_back(node_of(knowledge, id, name, x, y, z, yaw));
}

Scene kitchen() {
  const Knowledge knowledge = kitchen_knowledge();
  Scene scene;
  scene.id = "kitchen";
  scene.simulator = Simulator::Ai2thor;
  scene.rooms = {{"kitchen_1", "kitchen", {{0, 0}, {5, 0}, {5, 4}, {0, 4}}}};
  // Fronts face -y, so furniture on the upper wall faces into the room; the dresser's front is turned to +x.
  add(scene, "diningtable_1", knowledge, "DiningTable", 2.5, 1.2, 0);
  add(scene, "countertop_1", knowledge, "CounterTop", 1.8, 3.6, 0);
  add(scene, "fridge_1", knowledge, "Fridge", 4.4, 3.55, 0);
  add(scene, "microwave_1", knowledge, "Microwave", 1.5, 3.65, 0.902);
  add(scene, "sink_1", knowledge, "Sink", 3.2, 3.6, 0);
  add(scene, "dresser_1", knowledge, "Dresser", 0.35, 1.5, 0, std::numbers::pi / 2);
  add(scene, "mug_1", knowledge, "Mug", 2.2, 1.0, 0.751);
  add(scene, "apple_1", knowledge, "Apple", 2.5, 1.0, 0.751);
  add(scene, "knife_1", knowledge, "Knife", 2.8, 1.1, 0.751);
  add(scene, "plate_1", knowledge, "Plate", 2.3, 1.35, 0.751);
  add(scene, "potato_1", knowledge, "Potato", 2.75, 1.35, 0.751);
  scene.agent.position = {1.5, 2.3};
  scene.edges = read_relations(scene);
  return scene;
}

Scene full_kitchen(Simulator simulator) {
  const Knowledge knowledge = kitchen_knowledge(simulator);
  Scene scene = kitchen();
  scene.simulator = simulator;
  add(scene, "stove_1", knowledge, "Stove", 0.7, 3.6, 0);
  add(scene, "towel_1", knowledge, "Towel", 1.95, 3.45, 0.902);
  add(scene, "soapbar_1", knowledge, "SoapBar", 2.2, 3.45, 0.902);
  add(scene, "ketchup_1", knowledge, "Ketchup", 2.2, 3.7, 0.902);
  add(scene, "winebottle_1", knowledge, "WineBottle", 2.0, 3.75, 0.902).states.set({Predicate::Filled, "wine"});
  scene.edges = read_relations(scene);
  return scene;
}

Scene wide_kitchen(Simulator simulator) {
  const Knowledge knowledge = kitchen_knowledge(simulator);
  Scene scene = full_kitchen(simulator);
  add(scene, "sofa_1", knowledge, "Sofa", 4.3, 1.2, 0, -std::numbers::pi / 2);  // its front is turned to -x
  add(scene, "lamp_1", knowledge, "Lamp", 0.35, 1.5, 0.701);
  add(scene, "bulb_1", knowledge, "Bulb", 2.95, 1.4, 0.751);
  scene.edges = read_relations(scene);
  return scene;
}

Profile kitchen_profile(Simulator simulator, ActionProfile actions) {
  Profile profile;
  profile.simulator = simulator;
  profile.actions = actions_of(simulator, actions);
  profile.attaching = profile.power_needs_plug = actions == ActionProfile::Wide;
  return profile;
}

}  // namespace unietp::testing
