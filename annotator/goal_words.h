#pragma once

#include <set>
#include <string>

#include "logic/formula.h"

namespace unietp {

/// The predicates, symbols, categories and operators of a goal that correspond to single words.
struct GoalWords {
  std::set<Predicate> predicates;    // its states and relations, in the goal itself and in what is meant (`:where`)
  std::set<std::string> symbols;     // colors, materials, substances
  std::set<std::string> categories;  // also those of slices
  std::set<int> numbers;             // of counts above one
  bool every = false, none = false;  // `forall` of something, of nothing
  bool exactly = false, at_least = false, at_most = false;  // of counts
  bool order = false;                                       // before, until
  bool throughout = false, sometime = false;                // always; sometime
};
/// Those of the whole goal. Deterministic.
GoalWords words_of_goal(const Formula& goal);

}  // namespace unietp
