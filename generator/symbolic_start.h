#pragma once

#include "symbolic/world.h"

namespace unietp {

/// A start without any geometry. The setting points to the rules of the sampler that drew it.
struct SymbolicStart {
  symbolic::Setting setting;
  symbolic::World world;
};

}  // namespace unietp
