#pragma once

#include <string>

#include "logic/formula.h"

namespace unietp {

/// Which bound of core/limits.h a formula exceeds (its parts, quantifiers in one another, temporal operators in one
/// another), with what is accepted; "" for none. Evaluation and normal forms take time by a power of the nesting.
std::string excess_of(const Formula& formula);

}  // namespace unietp
