#pragma once

#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "pddl/domain_parts.h"
#include "pddl/process_class.h"
#include "scene/action.h"

namespace unietp::pddl {

/// "unietp-ai2thor".
std::string domain_name(Simulator simulator);

/// The domain of a simulator: preconditions and effects of its actions, by scene/action_table.h, for everything in its
/// knowledge base. Typed, with negative preconditions; effects are conditional only
/// where one action affects objects differently (those in a fridge when its door shuts) or updates monitors of temporal
/// goals. Deterministic.
std::string domain_text(const Knowledge& knowledge, ActionProfile profile = ActionProfile::Unietp);

/// The domain's actions without those for monitors.
std::vector<ActionText> actions_of(const ActionSet& offered, const std::vector<ProcessClass>& processes);
/// The domain's predicates without those of monitors.
std::vector<PredicateText> predicates_of(const ActionSet& offered, const std::vector<ProcessClass>& processes);
/// Affordances that direct actions need, without those that every domain has: "foldable".
std::vector<std::string_view> affordances_for(const ActionSet& offered);

/// The effect by which a state begins and those that exclude it end: "(hot ?w) (not (cool ?w)) (not
/// (room_temperature ?w))".
std::string becomes(Predicate state, const std::string& thing);
/// The name of the composite action that a process stands for on a tool, such as
/// "heat_with-inside-closed-running-door".
std::string composite_name(const ProcessClass& process);

}  // namespace unietp::pddl
