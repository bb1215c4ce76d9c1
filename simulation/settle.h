#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "scene/geometry.h"
#include "simulation/collider.h"

namespace unietp {

/// Time step and stopping criteria of a settling simulation.
struct SettleOptions {
  double step_s = 1.0 / 240;
  int max_steps = 720;        // 3 s
  int calm_steps = 12;        // ends after 0.05 s of calm
  int edge_calm_steps = 120;  // 0.5 s, when something rests with its center near the edge of its support
  double calm_m_s = 0.01, calm_rad_s = 0.05;
  double surroundings_m = 0.3;  // fixed bodies farther than this from the loose ones are left out
  /// Ends when this is done, not calm: of each step the loose bodies and the pairs of bodies that may touch count. A
  /// heap of things costs many times what as many things cost that stand apart.
  std::size_t most_work = std::numeric_limits<std::size_t>::max();
};

/// A body in a settling simulation.
struct SettlingBody {
  const Collider* collider = nullptr;
  Pose pose;
  double mass = 0;
};

/// Where the loose bodies come to rest among the fixed ones; poses in the order of `loose`.
struct Rest {
  std::vector<Pose> poses;
  bool calm = false;
  std::size_t work = 0;  // as SettleOptions::most_work counts it
};
/// Only the parts of fixed bodies near `region` are simulated. Deterministic.
Rest come_to_rest(const std::vector<SettlingBody>& fixed, const std::vector<SettlingBody>& loose, const Bounds& region,
                  const SettleOptions& options);

}  // namespace unietp
