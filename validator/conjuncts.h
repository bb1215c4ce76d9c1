#pragma once

#include <string>
#include <vector>

#include "logic/formula.h"

namespace unietp {

/// The parts of a goal that have to be achieved, one per conjunct, each with the quantifiers that bind its variables.
/// All of them must be false at the start. Parts that only have to stay true are left out: `always`, inequality of
/// variables, empty hands. "Open it, and it is closed at the end" is one part, since its second half is true at the
/// start.
std::vector<Formula> conjuncts_of(const Formula& goal);

/// A quantifier's domain that selects objects by facts of the start and mentions no other variables.
struct ReferringDomain {
  std::string variable;
  Domain domain;
  bool certain = false;  // the goal cannot be reached without a referent: under no `or`, `not`, `imply`
};
/// The referring domains of a goal, in order of text.
std::vector<ReferringDomain> referring_domains(const Formula& goal);

}  // namespace unietp
