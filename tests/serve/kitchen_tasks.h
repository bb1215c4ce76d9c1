#pragma once

#include <string>
#include <vector>

#include "serve/protocol.h"

namespace unietp::testing {

/// A server's tasks without a data set: every seed gives the same, to put the mug of the kitchen of
/// tests/simulation/kitchen.h on the counter. Seed 99 cannot be loaded, with an error that names a file.
ServedTasks kitchen_tasks();
/// Actions of M1 that reach its goal, `stop` at the end.
const std::vector<std::string>& kitchen_plan();

}  // namespace unietp::testing
