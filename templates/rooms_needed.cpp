#include "templates/rooms_needed.h"

#include <algorithm>

namespace unietp {
namespace {

/// Whether an `in_room` stands below an odd number of negations.
bool keeps_out_of_a_room(const Formula& formula, bool negated) {
  if (formula.op == Formula::Op::Atom) return negated && formula.predicate == Predicate::InRoom;
  const bool turns = formula.op == Formula::Op::Not;
  return std::any_of(formula.children.begin(), formula.children.end(),
                     [&](const Formula& child) { return keeps_out_of_a_room(child, negated != turns); });
}

}  // namespace

bool needs_several_rooms(const Template& source) {
  return std::any_of(source.init.begin(), source.init.end(),
                     [](const Formula& start) { return keeps_out_of_a_room(start, false); });
}

}  // namespace unietp
