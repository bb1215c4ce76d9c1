#pragma once

#include <string>
#include <vector>

#include "scene/trace.h"

namespace unietp {

/// What a simulator says of an action.
struct SimulatorAnswer {
  bool success = false;
  std::string message;              // why not; "" with success
  Delta changes;                    // of its own state, in our scene graph
  std::vector<Delta> moments = {};  // the same from moment to moment, where it passed through several; else empty
  bool operator==(const SimulatorAnswer&) const = default;
};

}  // namespace unietp
