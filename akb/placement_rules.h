#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/error.h"

namespace unietp {

/// Common sense for a group of words: things of `kind` are found `relation` things of kind `receptacle`.
struct PlacementRule {
  std::string kind, relation, receptacle;
  double weight = 1;
};

/// Errors are appended, with line and column.
std::vector<PlacementRule> read_placement_rules(const std::filesystem::path& path, std::vector<Error>& errors);

}  // namespace unietp
