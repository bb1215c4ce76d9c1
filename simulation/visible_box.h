#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "simulation/outline.h"

namespace unietp {

inline constexpr PixelBox kNowhere{std::numeric_limits<int>::max(), std::numeric_limits<int>::max(), -1, -1};

/// The smallest box that holds both.
inline PixelBox around(const PixelBox& a, const PixelBox& b) {
  return {std::min(a[0], b[0]), std::min(a[1], b[1]), std::max(a[2], b[2]), std::max(a[3], b[3])};
}

inline bool meet(const PixelBox& a, const PixelBox& b) {
  return a[0] <= b[2] && b[0] <= a[2] && a[1] <= b[3] && b[1] <= a[3];
}

/// Boxes around the pixels that show an object, exactly as a ray through the middle of each pixel would find them.
/// Branch and bound: a part of the image is cut around what is known of the box, or halved, as long as it could make
/// the box larger and it is not settled which solid shows in it. What is settled by outlines and depths needs no ray;
/// single pixels are asked by ray.
class VisibleBoxes {
 public:
  /// Both must outlive it. Of solids that a ray enters at equal depths the first in the list shows.
  VisibleBoxes(const Camera& camera, const std::vector<Outline>& outlines);

  std::optional<PixelBox> of(std::int32_t owner);

 private:
  /// A solid that may show in a part of the image.
  struct Shown {
    std::uint32_t outline = 0;
    bool whole = false;  // a box that certainly fills the part, and so each part of it
    double nearest = 0;  // depth: nowhere in the part nearer than this
  };
  using Stack = std::vector<Shown>;
  /// Of the two stacks the solids that may show in a part under way.
  struct Among {
    std::size_t own = 0, own_end = 0, others = 0, others_end = 0;
  };

  /// Looks where an object that nothing hides reaches farthest, so that little is left to explore.
  void probe_corners(const Among& among);
  void probe(const Outline& outline, const Vec2& corner, const Among& among);
  void explore(const PixelBox& whole, const Among& among);
  void explore_part(const PixelBox& part, const Among& among);
  /// What of a part the owner's solids may show in, if that could make the box larger.
  std::optional<PixelBox> worth_exploring(const PixelBox& part, const Among& among) const;
  /// Of the owner's solids those that a box of another hides all over the part, and the other way round.
  void drop_hidden_behind_boxes(const PixelBox& part, Among& here);
  void cut(const PixelBox& part, const Among& among);
  bool shows_owner(int x, int y, const Among& among) const;
  /// Puts on the stack which of those from `begin` to `end` may show in the part; `filled`: the depth behind which
  /// nothing shows in it, as far as known.
  void gather(Stack& stack, std::size_t begin, std::size_t end, const PixelBox& part, double& filled) const;

  /// What most outlines are passed over by, close together in memory.
  struct Brief {
    double nearest = 0;
    PixelBox cover{};
    std::int32_t owner = -1;
    std::uint32_t outline = 0;  // position in the list
  };

  const Camera& camera_;
  const std::vector<Outline>& outlines_;
  std::vector<Brief> by_depth_;  // the nearest first
  std::int32_t owner_ = -1;
  std::optional<PixelBox> box_;
  bool probed_ = false;
  Stack own_, others_;  // the owner's solids and all others that matter in each part under way
};

}  // namespace unietp
