#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "akb/knowledge.h"
#include "sense/common_sense.h"

namespace unietp {

/// A place where things of a category are found in a home.
struct UsualPlace {
  const Placement* placement = nullptr;  // of the knowledge base: relation `on` or `inside`, receptacle, capacity
  Grade grade = Grade::Tolerable;        // usual or tolerable
  double weight = 0;                     // share among the places of the same grade; these sum to one
};

/// Where the things of a simulator are usually found: the placements that are physically possible and make sense. A
/// placement whose grade is senseless is left out. The weight is the score of the grade times the square root of the
/// knowledge base's likelihood, which keeps its order but leaves room for the less likely. Read only after making;
/// equal arguments give equal tables.
class UsualPlaces {
 public:
  /// `knowledge` must outlive this value. Grading is done once for each kind and place, so this takes milliseconds.
  UsualPlaces(const Knowledge& knowledge, const CommonSense& sense);

  /// Usual places first, each grade by weight, the heaviest first, then by name. Empty for an unknown category and for
  /// one that is nowhere in its place, such as things of gardens and laboratories.
  const std::vector<UsualPlace>& of(std::string_view category) const;
  /// Only the usual ones; the tolerable ones when none is usual.
  std::vector<UsualPlace> best_of(std::string_view category) const;

 private:
  std::map<std::string, std::vector<UsualPlace>, std::less<>> places_;  // by category
};

/// The role of being on, in, next to or under a thing of a kind: "in:fridge", "next_to:cup".
Role role_of(Predicate relation, const std::string& kind, const Kinds& kinds);

/// Whether a placement is senseless, so that the importers leave it out. Always so for what a special place is not made
/// for. Else never so for a category without a kind, for what can be carried but is not of a home where nobody judged
/// that place, nor for a case of things of its own kind, such as tools in a toolbox.
bool is_absurd(const CommonSense& sense, Simulator simulator, const Category& object, Predicate relation,
               const Category& receptacle);

/// Grades one placement row: a thing of a category on, in, next to or under another. Tolerable for a category without a
/// kind.
Sense grade_placement(const Placement& placement, const Knowledge& knowledge, const CommonSense& sense);

}  // namespace unietp
