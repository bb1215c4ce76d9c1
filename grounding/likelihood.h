#pragma once

#include <cstddef>
#include <string>

#include "grounding/make_node.h"
#include "grounding/workspace.h"

namespace unietp {

/// How likely it is, among all places of a movable thing, that it is on or in another thing of the workspace: the
/// weight of such a place (Household::places_of) times how well its room suits (Household::in_room). At least 1e-6, and
/// 1 without a household or for what it says nothing of.
double likelihood_of_place(const Workspace& workspace, const Node& node, Predicate relation, std::size_t host);

/// How likely a thing is as it is there: of each state that the household speaks of, its share where the thing has it,
/// the rest where it has not, all multiplied; at least 0.001, and 1 without a household.
double likelihood_of_states(const Workspace& workspace, const Node& node, const HostRelation& host_relation);

/// The share of such things where it is, as last read, that are in a state; at least 0.001, and 1 without a household.
double share_in_state(const Workspace& workspace, const Node& node, const State& state);

/// A smaller share of things at a place hardly ever is in a state.
inline constexpr double kHardlyAny = 0.01;

/// Whether hardly anything is on or in such a receptacle as the thing is: no dirty plate is kept in a cabinet,
/// nothing that is not cold in a fridge. False without a household.
bool is_rare_at(const Workspace& workspace, const Node& node, const Node& receptacle);

/// Whether something is in the receptacle, as last read, with which nobody keeps things of the thing's category in
/// there (Household::stored_apart), though the home has no two such things there itself.
bool is_kept_apart_in(const Workspace& workspace, const Node& node, Predicate relation, std::size_t host);

/// How odd it is to find something.
enum class Oddness : std::uint8_t {
  None,
  Unusual,   // at a tolerable place, while others are usual
  Senseless  // in a room or at a place where nobody keeps such things, in a state that hardly any is in there, or
             // beside what safety keeps apart from it
};
/// How odd a movable thing is where and as it is, as last read; None without a household. `reason`, if given, is set to
/// the reason, for people.
Oddness oddness_of(const Workspace& workspace, const Node& node, std::string* reason = nullptr);

}  // namespace unietp
