#include "grounding/packing.h"

#include <algorithm>

#include "simulation/touch.h"

namespace unietp {
namespace {

constexpr int kMostComparisons = 100000;  // of two things at two spots
constexpr double kDepth_m = 0.001;        // what overlaps by less may still be pushed apart

struct Placed {
  Bounds bounds;
  std::vector<Convex> parts;
};

bool overlap_at(const Placed& a, const Placed& b) {
  if (!overlap(a.bounds, b.bounds)) return false;
  return std::any_of(a.parts.begin(), a.parts.end(), [&](const Convex& one) {
    return std::any_of(b.parts.begin(), b.parts.end(), [&](const Convex& other) {
      if (!overlap(one.bounds, other.bounds)) return false;
      const auto touching = touch(one, other);
      return touching && touching->depth > kDepth_m;
    });
  });
}

class Packing {
 public:
  explicit Packing(const std::vector<ObjectWithPoses>& things) {
    for (const ObjectWithPoses& thing : things) {
      auto& spots = things_.emplace_back();
      for (const Pose& pose : thing.spots)
        spots.push_back({thing.collider->bounds(pose), thing.collider->placed(pose)});
    }
    // Who has least choice chooses first.
    std::stable_sort(things_.begin(), things_.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
  }

  bool fits(std::size_t thing) {
    if (thing == things_.size()) return true;
    for (const Placed& spot : things_[thing]) {
      const bool free = std::none_of(taken_.begin(), taken_.end(), [&](const Placed* other) {
        ++comparisons_;
        return overlap_at(spot, *other);
      });
      if (comparisons_ > kMostComparisons) return true;
      if (!free) continue;
      taken_.push_back(&spot);
      if (fits(thing + 1)) return true;
      taken_.pop_back();
    }
    return false;
  }

 private:
  std::vector<std::vector<Placed>> things_;
  std::vector<const Placed*> taken_;
  int comparisons_ = 0;
};

}  // namespace

bool fit_together(const std::vector<ObjectWithPoses>& things) { return Packing(things).fits(0); }

}  // namespace unietp
