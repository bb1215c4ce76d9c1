#pragma once

#include <optional>
#include <string>

#include "annotator/clause.h"
#include "annotator/clause_writing.h"
#include "annotator/naming.h"

namespace unietp {

/// An alternative for one thing that is open and one for the same thing closed: two sentences, "If the cabinet is open,
/// put a towel in it. If not, put one on a shelf."
bool says_if_or_else(const Clause& clause);
std::optional<std::string> if_or_else(const Clause& clause, Naming& naming, ClauseWriter& clauses);

}  // namespace unietp
