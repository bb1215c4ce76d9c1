#pragma once

#include "logic/formula.h"

namespace unietp {

/// Normal form of a goal: bound variables renamed apart (v0, v1, …), negation pushed to the atoms, at-end
/// pushed to the atoms (domains are rigid over a trace, so it commutes with every connective and quantifier), `exists`
/// pulled out of conjunctions, `forall` and `always` split over them, counts and comparisons in one of their equal
/// forms (`>= 1` is `exists`, `= 0` is `forall not`). Equal in truth to `formula` on every trace.
Formula expanded(const Formula& formula);

/// Whether two goals are equal after `expanded`, whatever their variables are called and in whatever order their parts
/// and neighboring quantifiers stand. True means equal on every trace; the converse is not claimed.
bool same_meaning(const Formula& left, const Formula& right);

/// The same for goals that are `expanded` already.
bool same_expanded(const Formula& left, const Formula& right);

/// The formula without its at-end operators. For formulas whose every atom stands under one.
Formula without_at_end(const Formula& formula);

/// Whether the only temporal operator inside is at-end.
bool only_at_end(const Formula& formula);

/// Whether the variable occurs free.
bool mentions(const Formula& formula, const std::string& variable);

}  // namespace unietp
