#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "logic/formula.h"
#include "symbolic/goal.h"

namespace unietp::pddl {

/// A problem and the names of its objects.
struct Problem {
  std::string text;
  std::vector<std::string> things, rooms, substances;  // names, in the order of the symbols
  bool watching = false;                               // it has monitors: each action is followed by note and judge
};

/// A goal in PDDL, over atoms of the last state and monitors.
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

/// Errors: Unsatisfiable, with the reason, for what our domains do not express: relations that only physics determines
/// (next to, under, nearest), states of the profile `wide`, temporal operators over more than one atom or inside one
/// another, and numbers that take too many literals (kMostText and kMostCases in goal_text.cpp).
Result<GoalText> goal_text(const symbolic::Goal& goal, const Problem& names);

/// `goal` was made for this setting and start. Errors: those of goal_text, and Unsatisfiable when it holds at the
/// start.
Result<Problem> problem_for(const std::string& id, Simulator simulator, const symbolic::Setting& setting,
                            const symbolic::World& start, const symbolic::Goal& goal);

/// All facts of a world that are not about monitors, sorted.
std::vector<std::string> facts_of(const symbolic::Setting& setting, const symbolic::World& world, const Problem& names);

/// An atom in the domain's predicates, "(hot mug_1)"; nullopt for predicates that the domain lacks.
std::optional<std::string> fact_of(const symbolic::Atom& atom, const Problem& names);

}  // namespace unietp::pddl
