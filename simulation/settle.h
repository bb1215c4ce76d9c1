#pragma once

#include <vector>

#include "simulation/physics.h"

namespace unietp {

/// A body as a settle sees it.
struct SettlingBody {
  const Collider* collider = nullptr;
  Pose pose;
  double mass = 0;
};

/// Where the loose bodies come to rest among the fixed ones; poses in the order of `loose`.
struct Rest {
  std::vector<Pose> poses;
  bool calm = false;
};
/// Of the fixed bodies only the parts near `region` take part. Deterministic.
Rest come_to_rest(const std::vector<SettlingBody>& fixed, const std::vector<SettlingBody>& loose, const Bounds& region,
                  const SettleOptions& options);

}  // namespace unietp
