#pragma once

#include <string>
#include <vector>

#include "scene/action.h"
#include "symbolic/world.h"

namespace unietp::symbolic {

/// One action of the catalogue. Physics shows next to what a thing comes to rest; here the step says it: `beside`
/// stands on or in the same place, or, when dropped, where the agent stands. With `under`, it is dropped under it.
struct Step {
  ActionType action = ActionType::Stop;
  Id target = kNobody;  // thing or room
  Id beside = kNobody;
  bool under = false;
  bool operator==(const Step&) const = default;
};
std::string to_text(const Setting& setting, const Step& step);  // "place_on(table_1)"

/// Does the step: the same needs, effects and side effects as in simulation/, but for geometry: what is asked of reach
/// is that the agent went to the thing or to what it rests on or in; what fits where is what the knowledge base says of
/// things of one kind; those of other kinds take no room from them. A failed step leaves the world as it was. Actions
/// of the body, the camera and the hand change nothing here.
Failure perform(const Setting& setting, World& world, const Step& step);

/// Whether the agent can act on a thing from where it stands; Failure::None when it can.
Failure out_of_reach(const Setting& setting, const World& world, Id thing);
/// Whether a thing has room on or inside another (`relation`), as things are now.
bool has_room(const Setting& setting, const World& world, Id thing, Predicate relation, Id place);

/// The states that a treatment sets, as simulation/effects.cpp has them; empty for what is not done by lying in or on a
/// tool.
const std::vector<Predicate>& sets(Treatment treatment);
/// The action that treats the held thing with a tool; nullopt where there is none.
std::optional<ActionType> action_for(Treatment treatment);
/// Does to all that rests on or in a tool what the tool does by itself as things are now.
void run_processes(const Setting& setting, World& world, Id tool, bool tap_runs);

// The steps that composite actions stand for.
Failure pick_up(const Setting& setting, World& world, Id thing);
Failure place(const Setting& setting, World& world, const Step& step);
Failure swing(const Setting& setting, World& world, Id thing, bool open);
Failure switch_power(const Setting& setting, World& world, Id thing, bool on);
/// With every check of the atomic steps that it stands for.
Failure treat_with(const Setting& setting, World& world, Id tool, Treatment treatment);
Failure slice(const Setting& setting, World& world, Id thing);
Failure pour_to(const Setting& setting, World& world, Id target);
Failure use_up(const Setting& setting, World& world, Id thing);
Failure wipe(const Setting& setting, World& world, Id thing);
Failure spread_to(const Setting& setting, World& world, Id thing);
// Those of the profile `wide`.
Failure take_seat(const Setting& setting, World& world, Id thing, Predicate as);
Failure stand_up(World& world);
Failure plug(const Setting& setting, World& world, Id thing, bool in);
Failure fold(const Setting& setting, World& world, Id thing);
Failure break_apart(const Setting& setting, World& world, Id thing);

}  // namespace unietp::symbolic
