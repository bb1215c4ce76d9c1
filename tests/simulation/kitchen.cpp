#include "tests/simulation/kitchen.h"

#include <numbers>

#include "tests/support/household.h"

namespace unietp::testing {

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
