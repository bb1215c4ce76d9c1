#include "tests/support/kitchen_knowledge.h"

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

}  // namespace unietp::testing
