#pragma once

#include <optional>

#include "core/rng.h"
#include "logic/formula.h"
#include "logic/trace.h"

namespace unietp {

/// Traces on which two goals are compared before they count as equal.
inline constexpr int kTracesCompared = 4000;

/// A trace on which one goal holds and the other does not; nothing when none of so many tells them apart. The traces
/// are made up over the objects and predicates that the goals speak of: some at random, most pressed to fulfil one goal
/// and not the other, or to miss it by one fact. States that exclude each other (open, closed) do so there, and traces
/// on which a goal ranges over nothing are left out, as tasks are. Deterministic in rng.
std::optional<Trace> telling_trace(const Formula& left, const Formula& right, int traces, Rng rng);

/// Whether two goals are true on the same traces: proven where `same_meaning` can, else decided by evaluation on
/// kTracesCompared traces. False is certain (some trace tells them apart).
bool equivalent(const Formula& left, const Formula& right);

}  // namespace unietp
