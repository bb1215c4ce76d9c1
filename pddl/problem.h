#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "logic/formula.h"
#include "symbolic/goal.h"

namespace unietp::pddl {

/// A problem and how its objects are called.
struct Problem {
  std::string text;
  std::vector<std::string> things, rooms, substances;  // names, in the order of the symbols
  bool watching = false;                               // monitors are kept: each action is followed by note and judge
};

/// What a goal is in PDDL, over atoms of one moment and monitors.
struct GoalText {
  struct Monitor {
    std::string name;
    symbolic::Atom atom;
    bool negative = false;
  };
  std::string goal;
  std::vector<Monitor> monitors;
  std::vector<std::pair<std::size_t, std::size_t>> ordered, kept;  // of monitors: `before`, `until`
};

/// Errors: Unsatisfiable, with the reason, for what PDDL does not say here: relations that physics shows afterwards
/// (next to, under, nearest), states of the profile `wide`, temporal operators over more than single truths or within
/// each other, numbers that would take more than a few thousand literals.
Result<GoalText> goal_text(const symbolic::Goal& goal, const Problem& names);

/// `goal` is written out for the setting and its start. Errors: those of goal_text; also when it holds at the start.
Result<Problem> problem_for(const std::string& id, Simulator simulator, const symbolic::Setting& setting,
                            const symbolic::World& start, const symbolic::Goal& goal);

/// All facts of a world that are not about monitors, sorted.
std::vector<std::string> facts_of(const symbolic::Setting& setting, const symbolic::World& world, const Problem& names);

/// "(hot mug_1)", of the domain's predicates; nullopt for what it does not have.
std::optional<std::string> fact_of(const symbolic::Atom& atom, const Problem& names);

}  // namespace unietp::pddl
