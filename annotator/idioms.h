#pragma once

#include <vector>

#include "annotator/clause.h"

namespace unietp {

/// Joins what people say in one breath: "take all the mugs off the table and put them down", "divide the mugs between
/// the desk and the shelf, with at least one on each". A clause that became part of another one is erased.
void join_idioms(std::vector<Clause>& clauses);

/// What is to be done to what is put somewhere becomes what it is called: "put a heated egg on a plate", "put a box
/// with a pen in it on a desk". A clause that became part of another one is erased.
void join_results(std::vector<Clause>& clauses);

/// What is done to a thing comes before it is put somewhere, so that "it" is what was named last: "wash the pan and put
/// it in the sink".
void order_as_done(std::vector<Clause>& clauses);

}  // namespace unietp
