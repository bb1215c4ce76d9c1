#pragma once

#include "akb/knowledge.h"
#include "logic/formula.h"
#include "scene/action.h"
#include "simulation/profile.h"

namespace unietp {

class Household;

/// A goal to reach in a home that is not known, and what is known of homes in general.
struct SearchProblem {
  const Formula& goal;
  const Knowledge& knowledge;
  const Profile& profile;
  const Household* usual = nullptr;  // where things are in a lived-in home; nullptr: as the knowledge base says
  Mode mode = Mode::M2;              // or M3
};

}  // namespace unietp
