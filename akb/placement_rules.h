#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/error.h"
#include "logic/vocabulary.h"

namespace unietp {

/// Common sense for a group of words: things of `kind` are found `relation` things of one of the kinds `receptacles`:
/// the one that the rule names, then those that also have one (a stove's oven for "oven", a cabinet's top for
/// "dresser").
struct PlacementRule {
  std::string kind;
  Predicate relation = Predicate::On;  // one of kPlacementRelations
  std::vector<std::string> receptacles;
  double weight = 1;
};

/// Reads placement_rules.csv and placement_kinds.csv of `curated`. Errors are appended, with line and column.
std::vector<PlacementRule> read_placement_rules(const std::filesystem::path& curated, std::vector<Error>& errors);

}  // namespace unietp
