#pragma once

#include <string>
#include <vector>

#include "pddl/domain.h"

namespace unietp::pddl {

/// Truths that a monitor can watch: all that one action may change.
struct Watched {
  Predicate predicate;
  std::string name;       // as a predicate of the domain
  std::string arguments;  // typed: "?x - thing ?y - room"
  std::string variables;  // "?x ?y"
};
const std::vector<Watched>& all_watched();

/// Temporal operators, for planners that know none. A problem that needs them says (watching) and names its monitors;
/// then each action is followed by `note`, which reads what each monitor watches, and `judge`, which keeps what has
/// come of it: (seen ?m), (missed ?m), (in-order ?first ?second), (not-kept ?first ?until). Where nothing is watched,
/// neither can happen.
std::vector<PredicateText> monitor_predicates();
std::vector<ActionText> monitor_actions();

}  // namespace unietp::pddl
