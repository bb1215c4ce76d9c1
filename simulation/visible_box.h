#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "simulation/outline.h"

namespace unietp {

/// The smallest box that holds both.
inline PixelBox around(const PixelBox& a, const PixelBox& b) {
  return {std::min(a[0], b[0]), std::min(a[1], b[1]), std::max(a[2], b[2]), std::max(a[3], b[3])};
}

inline bool meet(const PixelBox& a, const PixelBox& b) {
  return a[0] <= b[2] && b[0] <= a[2] && a[1] <= b[3] && b[1] <= a[3];
}

/// Boxes around the pixels that show an object, exactly as a ray through the middle of each pixel would find them.
/// Branch and bound: a part of the image is halved as long as it could make the box larger and it is not settled which
/// solid shows in it. What is settled by outlines and depths needs no ray; single pixels are asked by ray.
class VisibleBoxes {
 public:
  /// Both must outlive it. Of solids that a ray enters at equal depths the first in the list shows.
  VisibleBoxes(const Camera& camera, const std::vector<Outline>& outlines) : camera_(camera), outlines_(outlines) {}

  std::optional<PixelBox> of(std::int32_t owner);

 private:
  /// Looks where an object that nothing hides reaches farthest, so that little is left to explore.
  void probe_corners(std::size_t begin, std::size_t end);
  void probe(const Outline& outline, const Vec2& corner, std::span<const std::size_t> among);
  // `begin` and `end`: of the solids on the stack that may show in the part.
  void explore(const PixelBox& whole, std::size_t begin, std::size_t end);
  void explore_part(const PixelBox& part, std::size_t begin, std::size_t end);
  /// What of a part the owner's solids may show in, if that could make the box larger.
  std::optional<PixelBox> worth_exploring(const PixelBox& part, std::size_t begin, std::size_t end) const;
  void halve(const PixelBox& part, std::size_t begin, std::size_t end);
  bool shows_owner(int x, int y, std::span<const std::size_t> among) const;

  const Camera& camera_;
  const std::vector<Outline>& outlines_;
  std::int32_t owner_ = -1;
  std::optional<PixelBox> box_;
  std::size_t asked_ = 0;           // how many solids lie in the way of the owner's cover
  std::vector<std::size_t> stack_;  // of positions in the list: those that matter in each part under way
  std::vector<double> nearest_;     // of those of the part at hand
};

}  // namespace unietp
