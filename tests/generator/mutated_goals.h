#pragma once

#include <string_view>
#include <vector>

#include "logic/formula.h"

namespace unietp {

/// How a goal is misunderstood. A plan for the misunderstanding must not meet the goal.
enum class Mistake { WrongOrder, Decoy, OneTooMany, OneTooFew, PartLeftOut };
inline constexpr int kMistakes = static_cast<int>(Mistake::PartLeftOut) + 1;
std::string_view name_of(Mistake mistake);

struct MutatedGoal {
  Mistake mistake = Mistake::WrongOrder;
  Formula goal;
};
/// The goal with one of its operators changed, in all ways: `before` the other way round, `until` given up early, a
/// `:where` denied, an upper bound of a count passed by one, a number missed by one, one of the parts of an `and` left
/// out.
std::vector<MutatedGoal> mutated_goals(const Formula& goal);

}  // namespace unietp
