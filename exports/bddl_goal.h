#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "akb/knowledge.h"
#include "core/result.h"
#include "logic/formula.h"
#include "scene/scene.h"

namespace unietp {

/// A BDDL literal of a state: its predicate, and whether it is negated ("closed" is "not open").
struct BddlState {
  std::string_view name;
  bool negated = false;
};
std::optional<BddlState> bddl_state(Predicate predicate);
/// "ontop"; "" for what BDDL has no word for.
std::string_view bddl_relation(Predicate predicate);

struct BddlGoal {
  std::string text;
  std::vector<std::string> categories;  // that it ranges over, sorted
};

/// `names`: what the objects of the start are called, by id; used where a referring constraint picks some out.
/// Errors: as bddl_problem.
Result<BddlGoal> bddl_goal(const Formula& goal, const Scene& start, const Knowledge& knowledge,
                           const std::map<std::string, std::string>& names);

}  // namespace unietp
