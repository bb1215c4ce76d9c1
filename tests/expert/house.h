#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "core/rng.h"
#include "expert/expert.h"
#include "logic/formula.h"
#include "scene/scene.h"
#include "simulation/profile.h"

namespace unietp::testing {

/// A kitchen and a living room, built by hand, in the style of AI2-THOR: a table, a counter, a fridge, a microwave, a
/// sink, a dresser, a side table, a lamp, a television; mugs, plates, apples, potatoes, a knife, a box, a laptop.
Knowledge house_knowledge();
Scene house();
Profile house_profile();
/// The same rooms and furniture with more movable things, strewn over the furniture and into the fridge, in drawn
/// states.
Scene strewn_house(Rng rng);

Node& add(Scene& scene, const Knowledge& knowledge, const std::string& id, const std::string& category, double x,
          double y, double z, double yaw = 0);
/// The scene at rest with its edges read afresh.
Scene at_rest(Scene scene);
void set_state(Scene& scene, const std::string& id, Predicate state);

/// A goal in the house, and what is changed before the house comes to rest.
struct HouseCase {
  const char* name;
  const char* goal;
  void (*edit)(Scene&) = nullptr;
};
void PrintTo(const HouseCase& c, std::ostream* out);
/// Stands it on a height; meters.
void move_to(Scene& scene, const std::string& id, double x, double y, double z);
void mug_in_fridge(Scene& scene);
void all_dirty(Scene& scene);

Formula goal(const std::string& text);
std::string plan_of(const Demonstration& demonstration);
/// The actions done in a fresh world: empty when each succeeds and changes what the demonstration says, and the goal
/// holds on the trace by the direct evaluator; else what is wrong.
std::string replay(const Formula& goal, const Scene& start, const Demonstration& demonstration,
                   const Knowledge& knowledge, const Profile& profile);

}  // namespace unietp::testing
