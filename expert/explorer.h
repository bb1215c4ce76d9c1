#pragma once

#include <string>
#include <variant>
#include <vector>

#include "expert/demonstration.h"
#include "expert/execution_tree.h"
#include "simulation/mode_rules.h"

namespace unietp {

/// Why a plan could not be carried out under the rules of a mode.
struct Trouble {
  std::string text;                 // for people
  Failure failure = Failure::None;  // of the last action; NotSeenYet for a thing that was looked for in vain
};

/// Does a plan that names things by ids as the rules allow it, looking for each thing first. Where that does not go as
/// planned, since who looks for things comes to stand elsewhere, the rest is planned anew from there; or all of it,
/// with other things where others will do. It knows all that is in the tree's world. Gives what was done, without
/// `stop`; some of it may not be needed. `plan` ends with `stop`. Deterministic.
std::variant<std::vector<Action>, Trouble> explore(const ModeRules& rules, ExecutionTree& executions,
                                                   std::vector<Action> plan, const ExpertOptions& options);

}  // namespace unietp
