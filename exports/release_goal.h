#pragma once

#include <map>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "core/result.h"
#include "logic/formula.h"
#include "scene/scene.h"

namespace unietp {

/// A goal in the words of the paper's release.
struct ReleaseGoal {
  std::string json;                                           // their `logic_dict`
  std::map<std::string, std::vector<std::string>> referents;  // their `object_reference`, with our ids
};

/// Says a goal in the node types of the release, where it means the same in both: with equal truth on every trace of
/// this start, and no error of theirs. Pure. Errors: Unsatisfiable with the reason, in words, where it cannot be said.
Result<ReleaseGoal> release_goal(const Formula& goal, const Scene& start, const Knowledge& knowledge);

}  // namespace unietp
