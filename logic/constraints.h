#pragma once

#include <vector>

#include "logic/formula.h"

namespace unietp {

/// What a goal asks for without its constraints, which a hasty agent forgets: nothing has to stay as it is (`always`),
/// nothing has to come first (`before`, `until`), of "exactly n" and "at most n" more would do, and of "as many as" any
/// number. The goal itself where it has none.
Formula without_constraints(Formula goal);

/// The goal with objects named by category alone: no domain has a `:where`.
Formula without_references(Formula goal);

/// The goal without its constraints, but with one of its orders reversed: one formula for each `before` and `until`, in
/// order of text. What reaches it reaches the goal without its constraints, the second part first.
std::vector<Formula> with_an_order_reversed(const Formula& goal);

/// The goal without its constraints, but with one more than one of its "exactly n" says, more than one of its "at
/// most n" allows, or more of one kind than of the other where it says "as many as": one formula for each, in order of
/// text, then with fewer of the one kind. What reaches it with the same things reaches the goal without its
/// constraints, and not the goal.
std::vector<Formula> with_one_too_many(const Formula& goal);

/// What somebody takes a goal for who forgets a constraint.
struct HastyReading {
  Formula goal;
  bool takes_more = false;  // it asks for one too many
};
/// The goal without its constraints, then with one too many; then, where something has to stay as it is or so many of
/// what a phrase tells from others are counted, forgetting which is meant: where the goal says all but some, for as
/// many with one of those among them, and without constraints and referring phrases (any two instead of two red ones).
/// None where the goal has no constraint.
std::vector<HastyReading> hasty_readings(const Formula& goal);

}  // namespace unietp
