#pragma once

#include <functional>
#include <string>

#include "logic/formula.h"

namespace unietp {

/// Which bound of core/limits.h a formula exceeds (its parts, quantifiers in one another, temporal operators in one
/// another), with what is accepted; "" for none. Evaluation and normal forms take time by a power of the nesting.
std::string excess_of(const Formula& formula);

/// Over how many combinations of objects the quantifiers of a formula range, where `members` says how many a domain
/// has. Evaluation and formulas without quantifiers grow by it.
double combinations_of(const Formula& formula, const std::function<double(const Domain&)>& members);

}  // namespace unietp
