#pragma once

#include <optional>

#include "core/rng.h"
#include "logic/formula.h"
#include "logic/trace.h"

namespace unietp {

/// Number of traces on which two goals are compared.
inline constexpr int kTracesCompared = 4000;

/// A trace on which one goal holds and the other does not; nullopt when none of `traces` traces is one. They are
/// generated over the objects and predicates of the goals: some at random, most changed to fulfill one goal and not the
/// other, or to miss it by one fact. States that exclude each other (open, closed) do so there, and traces
/// on which a goal ranges over nothing are left out, as tasks are. Deterministic in rng.
std::optional<Trace> distinguishing_trace(const Formula& left, const Formula& right, int traces, Rng rng);

/// Whether two goals are true on the same traces: proven where `same_meaning` can, else decided by evaluation on
/// kTracesCompared traces. False is certain (some trace distinguishes them).
bool equivalent(const Formula& left, const Formula& right);

}  // namespace unietp
