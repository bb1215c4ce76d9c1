#pragma once

#include <string>

#include "core/rng.h"
#include "environment/environment.h"

namespace unietp::testing {

/// An agent that acts without a plan, mostly on what it was told of: something of every kind of action, by ids or boxes
/// as its mode wants them, now and then lists of actions and nonsense. It never says stop.
class RandomAgent {
 public:
  explicit RandomAgent(Rng rng) : rng_(rng) {}

  /// What it says next.
  std::string answer(const Environment& environment);

 private:
  std::string argument(const Environment& environment, bool may_be_room);
  std::string one_action(const Environment& environment);

  Rng rng_;
};

}  // namespace unietp::testing
