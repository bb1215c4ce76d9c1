#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "simulation/coverage.h"

namespace unietp {

/// The empty box; neutral for `around`.
inline constexpr PixelBox kNowhere{std::numeric_limits<int>::max(), std::numeric_limits<int>::max(), -1, -1};

/// The smallest box that holds both.
inline PixelBox around(const PixelBox& a, const PixelBox& b) {
  return {std::min(a[0], b[0]), std::min(a[1], b[1]), std::max(a[2], b[2]), std::max(a[3], b[3])};
}

/// An object counts as seen if the image shows at least this many pixels of it, and at least this share of those that
/// it would show if nothing were before it.
inline constexpr int kLeastSeenPixels = 4;
inline constexpr int kLeastSeenPart = 100;  // one of so many

/// Boxes around the visible pixels of an object, exactly as a ray through the center of each pixel would find them,
/// through whatever glass lies before it.
/// Branch and bound: a part of the image is split while it could enlarge the box and it is not known which solid is
/// visible in it. Outlines and depths decide most parts; single pixels are decided by a ray.
class VisibleBoxes {
 public:
  /// Both must outlive it. Of solids at equal depths the first in the list is visible.
  VisibleBoxes(const Camera& camera, const std::vector<Outline>& outlines);

  /// The box of an object by the number of its outlines' owner; nullopt when too little of it is seen.
  std::optional<PixelBox> of(std::int32_t owner);

 private:
  /// A solid that may be visible in a part of the image.
  struct Shown {
    std::uint32_t outline = 0;
    bool whole = false;  // a box that certainly covers the part
    double nearest = 0;  // lower bound of its depth in the part
    PixelBox cover{};    // of the outline, so that most are passed over without a look at it
  };
  using Stack = std::vector<Shown>;
  /// Ranges of the two stacks: the solids that may be visible in the current part.
  struct Ranges {
    std::size_t own = 0, own_end = 0, others = 0, others_end = 0;
  };

  /// Tests the extreme corners of the object first, which bounds the rest of the search when nothing hides it.
  void probe_corners(const Ranges& among);
  void probe(const Outline& outline, const Vec2& corner, const Ranges& among);
  void explore(const PixelBox& whole, const Ranges& among);
  void explore_part(const PixelBox& part, const Ranges& among);
  /// Pushes those that may be visible in the part; `filled`: the depth behind which nothing is visible in it.
  Ranges narrow(const PixelBox& part, const Ranges& among, double& filled);
  /// Whether the object counts as seen, of which the box is known. `cover`: of its outlines.
  bool shows_enough(const PixelBox& cover, const Ranges& among);
  /// Adds the pixels of a part that show it to `counted_`, until that is `limit`.
  void count(const PixelBox& part, const Ranges& among, std::int64_t limit);
  /// The rectangle of a part in which the owner's solids may be visible, if it could enlarge the box.
  std::optional<PixelBox> worth_exploring(const PixelBox& part, const Ranges& among) const;
  /// Drops the owner's solids that a box of another object hides in the whole part, and vice versa.
  void drop_hidden_behind_boxes(const PixelBox& part, Ranges& here);
  /// Halves a part and explores both.
  void cut(const PixelBox& part, const Ranges& among);
  /// Looks at every pixel of a small part.
  void decide(const PixelBox& part, const Ranges& among);
  bool shows_owner(int x, int y, const Ranges& among) const;
  /// Pushes those from `begin` to `end` that may be visible in the part; `filled`: the depth behind which nothing is
  /// visible in it, as far as known.
  void gather(Stack& stack, std::size_t begin, std::size_t end, const PixelBox& part, double& filled) const;

  /// The data by which most outlines are rejected, compact in memory.
  struct OutlineSummary {
    double nearest = 0;
    PixelBox cover{};
    std::int32_t owner = -1;
    std::uint32_t outline = 0;  // position in the list
  };

  const Camera& camera_;
  const std::vector<Outline>& outlines_;
  std::vector<OutlineSummary> by_depth_;  // the nearest first
  std::int32_t owner_ = -1;
  std::optional<PixelBox> box_;
  bool probed_ = false;
  std::int64_t counted_ = 0;  // pixels that show it
  Stack own_, others_;        // the owner's solids and the others, of all parts on the recursion path
};

}  // namespace unietp
