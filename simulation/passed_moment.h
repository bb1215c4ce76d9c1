#pragma once

#include "scene/trace.h"
#include "simulation/moment_id.h"

namespace unietp {

/// A moment that one action leads through, and what changed since the moment before it.
struct PassedMoment {
  MomentId moment;
  Delta changes;
};

}  // namespace unietp
