#pragma once

#include <vector>

#include "logic/formula.h"

namespace unietp {

/// What a goal asks for without its constraints, which a hasty agent forgets: nothing has to stay as it is (`always`),
/// nothing has to come first (`before`, `until`), and of "exactly n" more would do. The goal itself where it has none.
/// That what is poured out of a thing was filled in before says how it is done, and is no constraint.
Formula without_constraints(Formula goal);

/// The goal with objects named by category alone: no domain has a `:where`.
Formula without_references(Formula goal);

/// Whether it constrains the way to it (`always`, `before`, `until`), not only its end.
bool constrains_the_way(const Formula& goal);

/// The goal without its constraints, but with one of its orders reversed: one formula for each `before` and `until`, in
/// order of text. What reaches it reaches the goal without its constraints, the second part first.
std::vector<Formula> with_an_order_reversed(const Formula& goal);

}  // namespace unietp
