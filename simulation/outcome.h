#pragma once

#include <string>

#include "scene/action.h"

namespace unietp {

/// What the agent is told after an action.
struct Outcome {
  bool success = false;
  Failure failure = Failure::None;
  std::string feedback;  // a sentence for the agent; "" on success
};

}  // namespace unietp
