#pragma once

#include <filesystem>
#include <functional>
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
/// nullopt for what BDDL has no word for.
std::optional<BddlState> bddl_state(Predicate predicate);
/// "ontop"; "" for what BDDL has no word for.
std::string_view bddl_relation(Predicate predicate);

/// OmniGibson's synset of each of its categories: data/bddl/synsets.csv.
using BddlSynsets = std::map<std::string, std::string, std::less<>>;
/// Errors: Io; those of a table that is none.
Result<BddlSynsets> read_bddl_synsets(const std::filesystem::path& file);

/// A goal in BDDL.
struct BddlGoal {
  std::string text;
  std::vector<std::string> categories;  // that it ranges over, sorted
};

/// `names`: what the objects of the start are called, by id; used where a referring constraint picks some out, and
/// where a synset is more than a category. Errors: as bddl_problem.
Result<BddlGoal> bddl_goal(const Formula& goal, const Scene& start, const Knowledge& knowledge,
                           const BddlSynsets& synsets, const std::map<std::string, std::string>& names);

}  // namespace unietp
