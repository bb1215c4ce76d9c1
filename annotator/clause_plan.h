#pragma once

#include <vector>

#include "annotator/clause.h"
#include "annotator/phrase_plan.h"

namespace unietp {

/// A state formula as a clause. Its free variables are in the scope of `phrases`, whose error is the first part that no
/// clause can express. Deterministic.
Clause planned_clause(const Formula& formula, PhrasePlanner& phrases);

/// Joins clauses that say the same of several subjects: "put a mug and a bowl on a table".
void join_subjects(std::vector<Clause>& clauses);

}  // namespace unietp
