#pragma once

#include "akb/knowledge.h"

namespace unietp::testing {

/// Knowledge of the things of a kitchen (tests/simulation/kitchen.h), with the effects of its appliances and no
/// placements.
Knowledge kitchen_knowledge(Simulator simulator = Simulator::Ai2thor);

}  // namespace unietp::testing
