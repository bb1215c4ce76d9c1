#pragma once

#include <string>
#include <vector>

#include "logic/formula.h"

namespace unietp {

/// What a goal asks to be brought about, conjunct by conjunct, each with the quantifiers that bind its variables: a
/// proper start makes every one false. Not among them is what only has to stay as it is: `always`, inequality of
/// variables, empty hands. "Open it, and closed at the end" is one conjunct, since its second half is true from the
/// start.
std::vector<Formula> conjuncts_of(const Formula& goal);

/// A domain that tells things apart by what they are at the start, without help of other variables.
struct ReferringDomain {
  std::string variable;
  Domain domain;
  bool certain = false;  // whoever fulfils the goal needs a referent: under no `or`, `not`, `imply`
};
std::vector<ReferringDomain> referring_domains(const Formula& goal);

}  // namespace unietp
