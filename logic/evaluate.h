#pragma once

#include "core/result.h"
#include "logic/formula.h"
#include "logic/trace.h"

namespace unietp {

/// Truth of a goal at position 0 of a trace: a direct reading of the table in docs/logic.md, kept apart from Monitor on
/// purpose. Pure. The trace has at least one state; the goal has no free variables.
bool holds(const Formula& goal, const Trace& trace);

/// Truth of a state formula in one state.
bool holds_in(const Formula& formula, const Trace& trace, std::size_t position);

/// As holds_in with some variables given (name, entity).
using Assignment = std::vector<std::pair<std::string, EntityIndex>>;
/// The same with free variables, which the assignment must all name.
bool holds_in(const Formula& formula, const Trace& trace, std::size_t position, const Assignment& assignment);

/// Entities in a domain, in index order: over the whole trace, `:where` read at position 0. `variable` is the name that
/// `where` uses for the object itself.
std::vector<EntityIndex> members_of(const Domain& domain, const std::string& variable, const Trace& trace,
                                    const Assignment& assignment = {});

/// Each `forall`, `count` and `number` whose domain is empty on the trace: a task with one is refused, never vacuously
/// solved. Texts of the domains, in order of appearance; empty when sound.
std::vector<std::string> empty_domains(const Formula& goal, const Trace& trace);

}  // namespace unietp
