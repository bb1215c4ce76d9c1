#pragma once

#include <vector>

#include "annotator/clause.h"

namespace unietp {

/// Joins what people say in one breath: "take all the mugs off the table and put them down", "divide the mugs between
/// the desk and the shelf, with at least one on each". A clause that became part of another one is erased.
void join_idioms(std::vector<Clause>& clauses);

/// What is done to a thing comes before it is put somewhere, so that "it" is what was named last: "wash the pan and put
/// it in the sink". Only what is turned on is put in its place first.
void order_as_done(std::vector<Clause>& clauses);

}  // namespace unietp
