#include "tests/expert/house.h"

#include <algorithm>
#include <numbers>
#include <ostream>
#include <stdexcept>

#include "expert/situation.h"
#include "logic/evaluate.h"
#include "scene/fresh_id.h"
#include "simulation/feedback.h"
#include "simulation/relations.h"
#include "simulation/shape.h"
#include "tests/support/household.h"

namespace unietp::testing {

Knowledge house_knowledge() {
  std::vector<Category> categories{
      category("Apple", true, Archetype::Sphere, {0.08, 0.08, 0.08}, 0.2),
      category("AppleSliced", true, Archetype::Box, {0.02, 0.08, 0.08}, 0.05),
      category("Box", true, Archetype::Lidded, {0.3, 0.25, 0.2}, 0.8),
      category("CounterTop", false, Archetype::Block, {1.4, 0.6, 0.9}, 60),
      category("DiningTable", false, Archetype::Table, {1.4, 0.9, 0.75}, 25),
      category("Dresser", false, Archetype::Drawers, {0.8, 0.45, 0.7}, 30),
      category("Fridge", false, Archetype::Cabinet, {0.7, 0.65, 1.7}, 80),
      category("Knife", true, Archetype::Box, {0.22, 0.025, 0.02}, 0.1),
      category("Lamp", true, Archetype::Cylinder, {0.15, 0.15, 0.3}, 1),
      category("Laptop", true, Archetype::Folding, {0.34, 0.24, 0.03}, 1.5),
      category("Microwave", false, Archetype::Cabinet, {0.5, 0.36, 0.3}, 12),
      category("Mug", true, Archetype::Vessel, {0.09, 0.09, 0.1}, 0.3),
      category("Plate", true, Archetype::Plate, {0.24, 0.24, 0.02}, 0.4),
      category("Potato", true, Archetype::Box, {0.09, 0.06, 0.06}, 0.2),
      category("PotatoSliced", true, Archetype::Box, {0.02, 0.06, 0.06}, 0.05),
      category("SideTable", false, Archetype::Table, {0.6, 0.6, 0.6}, 10),
      category("Sink", false, Archetype::Basin, {0.6, 0.5, 0.9}, 40),
      category("Television", false, Archetype::Panel, {1.0, 0.1, 0.6}, 10),
  };
  std::vector<AffordanceFact> affordances;
  const auto affords = [&](const std::string& name, std::initializer_list<const char*> what) {
    for (const char* affordance : what) affordances.push_back({name, affordance, curated()});
  };
  affords("Apple", {"pickupable", "sliceable"});
  affords("AppleSliced", {"pickupable"});
  affords("Box", {"container", "openable", "pickupable", "receptacle"});
  affords("CounterTop", {"receptacle"});
  affords("DiningTable", {"receptacle"});
  affords("Dresser", {"container", "openable", "receptacle"});
  affords("Fridge", {"container", "openable", "receptacle"});
  affords("Knife", {"pickupable"});
  affords("Lamp", {"pickupable", "switchable"});
  affords("Laptop", {"openable", "pickupable", "switchable"});
  affords("Microwave", {"container", "openable", "switchable"});
  affords("Mug", {"container", "dirtyable", "heatable", "pickupable"});
  affords("Plate", {"dirtyable", "pickupable", "receptacle"});
  affords("Potato", {"heatable", "pickupable", "sliceable"});
  affords("PotatoSliced", {"pickupable"});
  affords("SideTable", {"receptacle"});
  affords("Sink", {"container"});
  affords("Television", {"switchable"});
  std::vector<Placement> placements;
  for (const char* thing : {"Apple", "Box", "Knife", "Lamp", "Laptop", "Mug", "Plate", "Potato"}) {
    for (const char* place : {"CounterTop", "DiningTable", "Dresser", "SideTable"}) {
      placements.push_back({thing, Predicate::On, place, 1, 4, curated()});
    }
    for (const char* place : {"Box", "Dresser", "Fridge", "Microwave", "Sink"}) {
      if (std::string_view(thing) != place) placements.push_back({thing, Predicate::Inside, place, 1, 4, curated()});
    }
  }
  std::vector<Effect> effects = appliance_effects();
  effects.push_back({"Fridge", Treatment::Cools, "Potato", "", 0, {EffectNeed::Closed, EffectNeed::Inside}, curated()});
  effects.push_back({"Knife", Treatment::Slices, "Potato", "PotatoSliced", 4, {EffectNeed::Held}, curated()});
  return Knowledge(Simulator::Ai2thor, std::move(categories), std::move(affordances), std::move(placements),
                   std::move(effects), {});
}

Node& add(Scene& scene, const Knowledge& knowledge, const std::string& id, const std::string& name, double x, double y,
          double z, double yaw) {
  return scene.nodes.emplace_back(node_of(knowledge, id, name, x, y, z, yaw));
}

Scene at_rest(Scene scene) {
  PhysicsWorld physics = physics_of(scene);
  std::vector<BodyId> loose;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (scene.nodes[i].movable) loose.push_back(BodyId::node(i));
  }
  for (const SettledBody& body : physics.settle(loose).bodies) scene.nodes.edit(body.body.index()).pose = body.pose;
  scene.edges = read_relations(scene);
  return scene;
}

void set_state(Scene& scene, const std::string& id, Predicate state) {
  Node& node = *edit_node(scene, id);
  node.states.set({state, ""});
  if (state == Predicate::Open) node.opening = 1;
  if (state == Predicate::Closed) node.opening = 0;
}

Scene house() {
  const Knowledge knowledge = house_knowledge();
  Scene scene;
  scene.id = "house";
  scene.simulator = Simulator::Ai2thor;
  scene.rooms = {{"kitchen_1", "kitchen", {{0, 0}, {5, 0}, {5, 4}, {0, 4}}},
                 {"living_room_1", "living_room", {{5, 0}, {9, 0}, {9, 4}, {5, 4}}}};
  scene.openings = {{"door_1", "kitchen_1", "living_room_1", {5, 1.5}, {5, 2.5}, 2.0}};
  constexpr double kQuarter = std::numbers::pi / 2;
  const auto put = [&](const char* id, const char* name, double x, double y, double z, double yaw = 0) {
    add(scene, knowledge, id, name, x, y, z, yaw);
  };
  // Fronts face -y: furniture on the upper wall faces into the room.
  put("diningtable_1", "DiningTable", 2.5, 1.0, 0);
  put("countertop_1", "CounterTop", 1.8, 3.6, 0);
  put("fridge_1", "Fridge", 4.4, 3.55, 0);
  put("microwave_1", "Microwave", 1.5, 3.65, 0.902);
  put("sink_1", "Sink", 3.2, 3.6, 0);
  put("dresser_1", "Dresser", 0.35, 1.8, 0, kQuarter);
  put("sidetable_1", "SideTable", 8.5, 3.5, 0);
  put("sidetable_2", "SideTable", 8.5, 0.5, 0);
  put("television_1", "Television", 7.0, 3.9, 0.8);
  put("lamp_1", "Lamp", 8.5, 3.6, 0.601);
  put("laptop_1", "Laptop", 8.5, 0.5, 0.601);
  put("box_1", "Box", 1.95, 1.2, 0.751);
  put("mug_1", "Mug", 2.2, 0.75, 0.751);
  put("mug_2", "Mug", 2.6, 0.75, 0.751);
  put("mug_3", "Mug", 2.2, 3.5, 0.902);
  put("apple_1", "Apple", 2.4, 1.0, 0.751);
  put("apple_2", "Apple", 2.3, 3.65, 0.902);
  put("knife_1", "Knife", 2.8, 0.95, 0.751);
  put("plate_1", "Plate", 2.35, 1.25, 0.751);
  put("plate_2", "Plate", 8.35, 3.35, 0.601);
  put("potato_1", "Potato", 2.75, 1.25, 0.751);
  scene.agent.position = {1.5, 2.3};
  set_state(scene, "mug_1", Predicate::Dirty);
  set_state(scene, "mug_2", Predicate::Dirty);
  set_state(scene, "plate_1", Predicate::Dirty);
  return at_rest(std::move(scene));
}

Scene strewn_house(Rng rng) {
  struct Area {
    Vec2 low, high;
    double z;
  };
  static const std::vector<Area> kAreas{
      {{2.0, 0.7}, {3.0, 1.3}, 0.751},                                       // dining table
      {{2.0, 3.45}, {2.4, 3.75}, 0.902},                                     // counter, beside the microwave
      {{0.25, 1.55}, {0.45, 2.05}, 0.701},                                   // dresser
      {{8.3, 3.3}, {8.7, 3.7}, 0.601},                                       // side tables
      {{8.3, 0.3}, {8.7, 0.7}, 0.601},     {{4.2, 3.45}, {4.6, 3.65}, 0.9},  // fridge
  };
  const Knowledge knowledge = house_knowledge();
  Scene scene = house();
  erase_if(scene.nodes, [](const Node& node) { return node.movable; });
  const std::vector<std::pair<std::string, int>> things{{"Mug", 4},   {"Apple", 3}, {"Plate", 2},  {"Potato", 2},
                                                        {"Knife", 1}, {"Lamp", 2},  {"Laptop", 1}, {"Box", 1}};
  for (const auto& [category, most] : things) {
    for (int i = 0; i < most; ++i) {
      const Vec3 size = knowledge.find(category)->size;
      for (int draw = 0; draw < 50; ++draw) {
        const Area& area = kAreas[rng.below(kAreas.size())];
        const Vec2 at(rng.uniform(area.low.x(), area.high.x()), rng.uniform(area.low.y(), area.high.y()));
        const bool free = std::none_of(scene.nodes.begin(), scene.nodes.end(), [&](const Node& node) {
          const double apart = (node.size.head<2>().maxCoeff() + size.head<2>().maxCoeff()) / 2 + 0.03;
          return node.movable && (node.pose.position.head<2>() - at).norm() < apart;
        });
        if (!free) continue;
        add(scene, knowledge, fresh_id(scene, category), category, at.x(), at.y(), area.z);
        break;
      }
    }
  }
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    Node& node = scene.nodes.edit(i);
    for (const StateGroup& group : state_groups()) {
      const bool appliance = node.category == "Microwave" && group.affordance == "switchable";
      if (knowledge.has(node.category, group.affordance) && !appliance && group.affordance != "sliceable") {
        set_state(scene, node.id, group.predicates[rng.below(2)]);
      }
    }
  }
  scene.agent.position = Vec2(rng.uniform(1.2, 3.5), rng.uniform(2.0, 2.6));
  return at_rest(std::move(scene));
}

Profile house_profile() { return {}; }

void PrintTo(const HouseCase& c, std::ostream* out) { *out << c.name; }

void move_to(Scene& scene, const std::string& id, double x, double y, double z) {
  Node& node = *edit_node(scene, id);
  node.pose.position = Vec3(x, y, z + node.size.z() / 2);
}

void mug_in_fridge(Scene& scene) { move_to(scene, "mug_1", 4.4, 3.55, 0.9); }

void all_dirty(Scene& scene) {
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    Node& node = scene.nodes.edit(i);
    if (node.states.has(Predicate::Clean)) node.states.set({Predicate::Dirty, ""});
  }
}

Formula goal(const std::string& text) {
  auto formula = parse_formula("goal", text, FormulaUse::Goal);
  if (!formula) throw std::runtime_error(format(formula.error()) + " in " + text);
  return *formula;
}

std::string plan_of(const Demonstration& demonstration) {
  std::string text;
  for (const DemonstrationStep& step : demonstration.steps) text += to_text(step.action) + " ";
  return text;
}

std::string replay(const Formula& goal, const Scene& start, const Demonstration& demonstration,
                   const Knowledge& knowledge, const Profile& profile) {
  auto world = World::create(start, knowledge, profile);
  if (!world) return format(world.error());
  std::vector<Delta> changes;
  for (const DemonstrationStep& step : demonstration.steps) {
    const Scene before = world->scene();
    const ActionResult outcome = world->step(step.action);
    if (!outcome.success) return to_text(step.action) + " failed: " + feedback_with_ids(outcome.detail);
    if (difference(before, world->scene()) != step.changes)
      return to_text(step.action) + " changes something else than recorded";
    for (Delta& change : world->changes_by_moment()) changes.push_back(std::move(change));
  }
  if (!world->stopped()) return "does not stop";
  return holds(goal, to_logic(start, changes, reads_comparisons(goal))) ? "" : "the goal does not hold";
}

}  // namespace unietp::testing
