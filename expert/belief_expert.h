#pragma once

#include <optional>

#include "akb/knowledge.h"
#include "expert/explorer.h"
#include "expert/window.h"
#include "logic/formula.h"
#include "simulation/profile.h"

namespace unietp {

class Household;

/// A goal to reach in a home that is not known, and what is known of homes in general.
struct SearchProblem {
  const Formula& goal;
  const Knowledge& knowledge;
  const Profile& profile;
  const Household* usual = nullptr;  // where things are in a lived-in home; nullptr: as the knowledge base says
};

/// Stage: reaches a goal in M2 by what can be known there. It looks for the things that the goal and its tools need, in
/// the order in which such things are usually found, plans in a world made of what it believes as soon as it has seen
/// enough, does the plan, and plans anew when it sees what it did not expect. Ends with `stop` once it believes that
/// the goal is reached. nullopt then; else why it gave up. Every action is a function of the problem and of what the
/// window showed before it. Deterministic.
std::optional<Trouble> reach_by_belief(const SearchProblem& problem, Window& window);

}  // namespace unietp
