#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/action.h"
#include "symbolic/world.h"

namespace unietp::symbolic {

/// One action of the table. Physics would show next to what a thing comes to rest; here the step says it: `beside`
/// stands on or in the same place or, when the thing is dropped, where the agent stands. With `under`, the thing is
/// dropped under it.
struct Step {
  ActionType action = ActionType::Stop;
  Id target = kNobody;  // thing or room
  Id beside = kNobody;
  bool under = false;
  bool operator==(const Step&) const = default;
};
std::string to_text(const Setting& setting, const Step& step);  // "place_on(table_1)"

/// Performs the step by the needs and changes of scene/action_table.h, with the side effects that simulation/ has, but
/// without geometry. In reach is what the agent went to, and what rests on or in that. What fits is what the knowledge
/// base says of things of one kind; things of other kinds take no room. A failed step leaves the world as it was.
/// Actions of the body and the camera change nothing here. `passed` gets the worlds that a composite action passes
/// through on its way to the last.
Failure perform(const Setting& setting, World& world, const Step& step, std::vector<World>* passed = nullptr);

/// The first need of the step's action that is not met; Failure::None when all are. Needs of kind Special are not
/// asked.
Failure first_unmet(const Setting& setting, const World& world, const Step& step);
/// Whether a rule holds of an action's target, with what the hand holds.
bool applies(const Setting& setting, const World& world, ActionRule rule, Id target);

/// Whether the agent can act on a thing from where it stands; Failure::None when it can.
Failure out_of_reach(const Setting& setting, const World& world, Id thing);
/// Whether a thing has room on or inside another (`relation`), as things are now.
bool has_room(const Setting& setting, const World& world, Id thing, Predicate relation, Id place);

/// Applies the tool's effects to everything that rests on or in it, if the conditions are met.
void run_processes(const Setting& setting, World& world, Id tool, bool tap_runs);

// Below: a step whose needs in the table are met, offered or not.
Failure perform_checked(const Setting& setting, World& world, const Step& step, std::vector<World>* passed = nullptr);
/// The atomic steps that a composite action (or soak_with) stands for in a world: up to where the tool works, and back.
/// A tap runs between the two. nullopt for other actions, or when the tool does nothing to what is held.
struct AtomicSteps {
  std::vector<Step> there, back;
  bool runs_tap = false;
};
std::optional<AtomicSteps> atomic_steps(const Setting& setting, const World& world, const Step& step);

/// A composite action, with all checks of the atomic steps that it stands for.
Failure treat_with(const Setting& setting, World& world, Id tool, Treatment treatment, std::vector<World>* passed);
/// Cuts a thing with the knife in the hand.
Failure slice(const Setting& setting, World& world, Id thing);

}  // namespace unietp::symbolic
