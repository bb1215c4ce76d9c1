#pragma once

#include <array>
#include <optional>
#include <queue>
#include <set>
#include <vector>

#include "scene/action.h"
#include "scene/scene.h"

namespace unietp {

/// A pose that the agent's body can reach, and the step that leads to it.
struct ReachedPose {
  Agent agent;
  double cost = 0;
  std::size_t from = 0;  // itself for the pose without a step before it
  Action by;
};

/// The poses of a search for a place to stand, in order of what it costs to come to them and, by an estimate, to go on
/// from there; of equals the one found first. The first one that is added is where the body is.
class Poses {
 public:
  using Key = std::array<long, 4>;  // poses of equal keys are the same

  /// Ignored when a pose of this key is there. `left`: an estimate of what it costs to go on from there to the end.
  void add(ReachedPose pose, const Key& key, double left = 0);
  /// The next one to look at; none when all were. What is added later may still come before others.
  std::optional<std::size_t> next();
  std::size_t size() const { return poses_.size(); }
  /// Valid until the next add.
  const ReachedPose& operator[](std::size_t at) const { return poses_[at]; }
  /// From where the body is.
  std::vector<Action> steps_to(std::size_t at) const;

 private:
  std::vector<ReachedPose> poses_;
  std::set<Key> known_;
  using Open = std::pair<double, std::size_t>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open_;
};

}  // namespace unietp
