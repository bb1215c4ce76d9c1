#pragma once

#include <set>
#include <string>
#include <vector>

namespace unietp::testing {

/// Names of the propositions that hold in each state.
using LtlfTrace = std::vector<std::set<std::string>>;

/// Truth of an LTLf formula at the beginning of a trace that is not empty, by the textbook definition (De Giacomo and
/// Vardi, 2013). Operators: ! & | F G U; `&` and `|` bind alike, so a text that mixes them needs parentheses. Throws
/// std::runtime_error for what it cannot read. Shares no code with the program.
bool ltlf_holds(const std::string& formula, const LtlfTrace& trace);

}  // namespace unietp::testing
