#pragma once

#include <vector>

#include "annotator/clause.h"

namespace unietp {

/// Joins what people say in one breath: "take all the mugs off the table and put them down", "divide the mugs between
/// the desk and the shelf, with at least one on each". A clause that became part of another one is erased.
void join_idioms(std::vector<Clause>& clauses);

}  // namespace unietp
