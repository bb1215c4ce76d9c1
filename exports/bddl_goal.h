#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "core/result.h"
#include "exports/bddl_words.h"
#include "logic/formula.h"
#include "scene/scene.h"

namespace unietp {

/// A goal in BDDL.
struct BddlGoal {
  std::string text;
  std::vector<std::string> categories;  // that it ranges over, sorted
  std::set<std::string> substances;     // synsets of those that it names
};

/// `names`: what the objects of the start are called, by id; used where a referring constraint picks some out, and
/// where a synset is more than a category. Errors: as bddl_problem.
Result<BddlGoal> bddl_goal(const Formula& goal, const Scene& start, const Knowledge& knowledge, const BddlWords& words,
                           const std::map<std::string, std::string>& names);

}  // namespace unietp
