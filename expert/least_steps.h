#pragma once

#include <cstddef>

#include "expert/attempt.h"

namespace unietp {

/// No fewer steps than these are still to be done for the end that an attempt is after, `stop` aside, so that what is
/// too much is seen before it is tried. Counted is what each thing needs of its own, and a walk for each that is out of
/// reach from where the others are. Pieces are left out: one cut makes many of them.
std::size_t least_steps(const Attempt& attempt);

}  // namespace unietp
