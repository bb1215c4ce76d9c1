#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "expert/subgoal.h"
#include "scene/action.h"
#include "scene/treatment.h"

namespace unietp {

/// How an action brings a state about.
enum class AchieverKind {
  Direct,      // done to the object itself: open(x)
  ToolOnHeld,  // done with a tool or place to the object in hand: wash_with(sink)
  HeldToolOn,  // done to the object with a tool in hand: slice(x) with a knife
  Appliance,   // the object is put into (or on) an appliance that is shut and switched on as the rule asks
  FromVessel,  // poured over from a vessel that is filled first
};

/// One way to bring a state about.
struct Achiever {
  Predicate predicate;
  AchieverKind kind;
  ActionType action;
  std::string_view affordance;              // Direct: of the object; FromVessel: of the vessel
  std::optional<Treatment> treatment = {};  // the others: what the tool must do to the object
};

/// The ways to a state that the simulator offers, best first.
std::vector<Achiever> achievers_of(Predicate predicate, const Profile& profile);

/// Effects in the knowledge base by which a tool that the scene has does this to the category (and leaves this symbol).
std::vector<const Effect*> rules_for(const Achiever& achiever, std::string_view category, std::string_view symbol,
                                     const NodeIndex& places, const Knowledge& knowledge);

/// A relation of an object to a place: on, inside, on the floor, in a room, next to, attached.
bool is_placement(Predicate predicate);
/// A state that changes while the object is in hand.
bool changes_in_hand(Predicate predicate);
/// False when nothing the agent can do makes the literal true.
bool achievable(const Literal& literal, const Situation& situation);

}  // namespace unietp
