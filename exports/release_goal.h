#pragma once

#include <map>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "core/result.h"
#include "interchange/format_facts.h"
#include "logic/formula.h"
#include "scene/scene.h"

namespace unietp {

/// A goal in the format of the paper's release.
struct ReleaseGoal {
  std::string json;                                           // their `logic_dict`
  std::map<std::string, std::vector<std::string>> referents;  // their `object_reference`, with our ids
};

/// Translates a goal where it means the same in both: equal truth on every trace that begins with this start, and no
/// error in the release's evaluator. Pure. Errors: Unsatisfiable with the reason why it cannot be expressed.
Result<ReleaseGoal> release_goal(const Formula& goal, const Scene& start, const Knowledge& knowledge,
                                 const FormatFacts& facts);

}  // namespace unietp
