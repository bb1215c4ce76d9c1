#include "expert/poses.h"

#include <algorithm>

namespace unietp {

void Poses::add(ReachedPose pose, const Key& key, double left) {
  if (!known_.insert(key).second) return;
  open_.emplace(pose.cost + left, poses_.size());
  poses_.push_back(std::move(pose));
}

std::optional<std::size_t> Poses::next() {
  if (open_.empty()) return std::nullopt;
  const std::size_t at = open_.top().second;
  open_.pop();
  return at;
}

std::vector<Action> Poses::steps_to(std::size_t at) const {
  std::vector<Action> steps;
  for (; at != 0; at = poses_[at].from) steps.push_back(poses_[at].by);
  std::reverse(steps.begin(), steps.end());
  return steps;
}

}  // namespace unietp
