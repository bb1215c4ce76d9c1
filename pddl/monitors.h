#pragma once

#include <string>
#include <vector>

#include "logic/vocabulary.h"
#include "pddl/domain_parts.h"
#include "scene/action.h"

namespace unietp::pddl {

/// A predicate that a monitor can watch: any that an action may change.
struct MonitoredPredicate {
  Predicate predicate;
  std::string name;       // as a predicate of the domain
  std::string arguments;  // typed: "?x - thing ?y - room"
  std::string variables;  // "?x ?y"
};
/// What every domain has, then the states that only an extension action sets and no other takes away.
const std::vector<MonitoredPredicate>& all_watched();
/// Those that a domain with these actions has.
std::vector<MonitoredPredicate> watched_with(const ActionSet& offered);

/// Temporal operators for planners that have none. A problem that needs them contains (watching) and declares its
/// monitors; then each action must be followed by `note`, which evaluates what each monitor watches, and `judge`, which
/// stores the result: (seen ?m), (missed ?m), (in-order ?first ?second), (not-kept ?first ?until). In other problems
/// neither is applicable.
std::vector<PredicateText> monitor_predicates(const ActionSet& offered);
std::vector<ActionText> monitor_actions(const ActionSet& offered);

}  // namespace unietp::pddl
