#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "akb/knowledge.h"
#include "core/rng.h"
#include "grounding/workspace.h"
#include "logic/formula.h"

namespace unietp {

/// Where a new piece of furniture may be tried.
struct NewPlace {
  std::size_t room = 0;
  std::string beside;  // category of what it is to stand next to; "": anything
};

/// Rooms for a new piece of a quantifier's domain that is to satisfy its body, the likeliest first: those that the
/// knowledge calls usual, a few of each type; where the body says next to what it stands or in which room, only rooms
/// in which that can be so. `names`: what outer variables stand for.
std::vector<NewPlace> places_for_new(const Formula& quantifier,
                                     const std::vector<std::pair<std::string, std::string>>& names,
                                     const Category& category, const Workspace& workspace, Rng& rng);

}  // namespace unietp
