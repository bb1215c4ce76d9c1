#pragma once

#include <vector>

#include "annotator/clause.h"
#include "annotator/phrase_plan.h"

namespace unietp {

/// What one state formula says, as a clause: its free variables are in the scope of `phrases`, which keeps the first
/// part that no clause says as its error. Deterministic.
Clause planned_clause(const Formula& formula, PhrasePlanner& phrases);

/// Joins clauses that say the same of several subjects: "put a mug and a bowl on a table".
void join_subjects(std::vector<Clause>& clauses);

}  // namespace unietp
