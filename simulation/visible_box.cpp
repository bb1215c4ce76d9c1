#include "simulation/visible_box.h"

#include <utility>

#include "simulation/coverage.h"

namespace unietp {
namespace {

PixelBox common_part(const PixelBox& a, const PixelBox& b) {
  return {std::max(a[0], b[0]), std::max(a[1], b[1]), std::min(a[2], b[2]), std::min(a[3], b[3])};
}

// Of so few pixels each is decided by a ray at once: cheaper than what bounds of the solids tell of their halves.
constexpr std::int64_t kFew = 4;

std::int64_t pixels_of(const PixelBox& box) {
  return std::int64_t{box[2] - box[0] + 1} * std::int64_t{box[3] - box[1] + 1};
}

/// A seventh of its width and height, in its middle.
PixelBox middle_of(const PixelBox& box) {
  const int wide = 3 * (box[2] - box[0]) / 7, high = 3 * (box[3] - box[1]) / 7;
  return {box[0] + wide, box[1] + high, box[2] - wide, box[3] - high};
}

}  // namespace

VisibleBoxes::VisibleBoxes(const Camera& camera, const std::vector<Outline>& outlines)
    : camera_(camera), outlines_(outlines) {
  by_depth_.reserve(outlines.size());
  for (const Outline& one : outlines)
    by_depth_.push_back({one.nearest, one.cover, one.owner, static_cast<std::uint32_t>(by_depth_.size())});
  std::sort(by_depth_.begin(), by_depth_.end(), [](const OutlineSummary& a, const OutlineSummary& b) {
    return std::pair(a.nearest, a.outline) < std::pair(b.nearest, b.outline);
  });
}

std::optional<PixelBox> VisibleBoxes::of(std::int32_t owner) {
  owner_ = owner;
  box_.reset();
  probed_ = false;
  counted_ = 0;
  std::optional<PixelBox> cover;
  double farthest = 0;
  for (const OutlineSummary& one : by_depth_) {
    if (one.owner != owner) continue;
    cover = cover ? around(*cover, one.cover) : one.cover;
    farthest = std::max(farthest, outlines_[one.outline].farthest);
  }
  if (!cover) return std::nullopt;
  own_.clear();
  others_.clear();
  for (const OutlineSummary& one : by_depth_) {
    if (one.nearest > farthest) break;
    if (one.owner != owner && outlines_[one.outline].clear) continue;  // the owner is seen through it
    if (meet(one.cover, *cover))
      (one.owner == owner ? own_ : others_).push_back({one.outline, false, one.nearest, one.cover});
  }
  const Ranges all{0, own_.size(), 0, others_.size()};
  explore(*cover, all);
  if (box_ && !shows_enough(*cover, all)) box_.reset();
  return box_;
}

void VisibleBoxes::probe_corners(const Ranges& among) {
  // Left, up, right, down: of all its solids the most extreme one.
  for (std::size_t side = 0; side < 4; ++side) {
    const Outline* farthest = nullptr;
    const auto reach = [side](const Outline& outline) {
      const double at = outline.extremes[side][side % 2 == 0 ? 0 : 1];
      return side < 2 ? -at : at;
    };
    for (std::size_t k = among.own; k < among.own_end; ++k) {
      const Outline& outline = outlines_[own_[k].outline];
      if (farthest == nullptr || reach(outline) > reach(*farthest)) farthest = &outline;
    }
    probe(*farthest, farthest->extremes[side], among);
  }
}

void VisibleBoxes::probe(const Outline& outline, const Vec2& corner, const Ranges& among) {
  const PixelBox& cover = outline.cover;
  const Vec2 middle = Vec2(cover[0] + cover[2] + 1, cover[1] + cover[3] + 1) / 2;
  for (const double inwards : {0.7, 2.0}) {  // pixels, since a corner may be narrower than a pixel
    const Vec2 at = corner + inwards * (middle - corner).normalized();
    const int x = static_cast<int>(std::clamp(at.x(), 1.0 * cover[0], 1.0 * cover[2]));
    const int y = static_cast<int>(std::clamp(at.y(), 1.0 * cover[1], 1.0 * cover[3]));
    const PixelBox pixel{x, y, x, y};
    if (box_ && within(pixel, *box_)) return;
    if (!shows_owner(x, y, among)) continue;
    box_ = box_ ? around(*box_, pixel) : pixel;
    return;
  }
}

void VisibleBoxes::explore(const PixelBox& whole, const Ranges& among) {
  const auto part = worth_exploring(whole, among);
  if (!part) return;
  if (pixels_of(*part) <= kFew) {
    decide(*part, among);
  } else {
    explore_part(*part, among);
  }
}

std::optional<PixelBox> VisibleBoxes::worth_exploring(const PixelBox& part, const Ranges& among) const {
  std::optional<PixelBox> own;
  for (std::size_t k = among.own; k < among.own_end; ++k) {
    const PixelBox& cover = own_[k].cover;
    if (!meet(cover, part)) continue;
    const PixelBox common = common_part(cover, part);
    own = own ? around(*own, common) : common;
  }
  if (!own || (box_ && within(*own, *box_))) return std::nullopt;
  return own;
}

void VisibleBoxes::gather(Stack& stack, std::size_t begin, std::size_t end, const PixelBox& part,
                          double& filled) const {
  const PartOfImage middles(part);
  for (std::size_t k = begin; k < end; ++k) {
    const Shown above = stack[k];
    if (above.nearest > filled || !meet(above.cover, part)) continue;
    const Outline& outline = outlines_[above.outline];
    const PartCoverage share = coverage_of(outline, part, middles, above.whole, camera_);
    if (!share.any || share.nearest > filled) continue;
    if (share.whole) filled = std::min(filled, share.farthest);
    stack.push_back({above.outline, share.whole && !outline.round, share.nearest, above.cover});
  }
}

VisibleBoxes::Ranges VisibleBoxes::narrow(const PixelBox& part, const Ranges& among, double& filled) {
  // Those that may be visible in the part, up to the depth of the first that covers it.
  Ranges here{own_.size(), 0, others_.size(), 0};
  filled = kNever;
  gather(own_, among.own, among.own_end, part, filled);
  gather(others_, among.others, among.others_end, part, filled);
  const auto drop_hidden = [filled](Stack& stack, std::size_t from) {
    const auto hidden = [filled](const Shown& shown) { return shown.nearest > filled; };
    stack.erase(std::remove_if(stack.begin() + static_cast<std::ptrdiff_t>(from), stack.end(), hidden), stack.end());
    return stack.size();
  };
  here.own_end = drop_hidden(own_, here.own);
  here.others_end = drop_hidden(others_, here.others);
  if (here.own_end > here.own && here.others_end > here.others) drop_hidden_behind_boxes(part, here);
  return here;
}

void VisibleBoxes::explore_part(const PixelBox& part, const Ranges& among) {
  double filled = kNever;
  const Ranges here = narrow(part, among, filled);
  const bool any_own = here.own_end > here.own, any_other = here.others_end > here.others;
  if (any_own && !any_other && filled < kNever) {
    box_ = box_ ? around(*box_, part) : part;
    counted_ += pixels_of(part);
  } else if (any_own) {
    if (!std::exchange(probed_, true)) probe_corners(here);  // for the largest part
    cut(part, here);
  }
  own_.resize(here.own);
  others_.resize(here.others);
}

void VisibleBoxes::drop_hidden_behind_boxes(const PixelBox& part, Ranges& here) {
  const PartOfImage middles(part);
  const auto drop = [&](const Shown& front, Stack& stack, std::size_t from) {
    if (!front.whole) return;
    const auto hidden = [&](const Shown& shown) {
      return certainly_before(outlines_[front.outline], outlines_[shown.outline], middles);
    };
    stack.erase(std::remove_if(stack.begin() + static_cast<std::ptrdiff_t>(from), stack.end(), hidden), stack.end());
  };
  for (std::size_t k = here.others; k < here.others_end; ++k) drop(others_[k], own_, here.own);
  here.own_end = own_.size();
  for (std::size_t k = here.own; k < here.own_end; ++k) drop(own_[k], others_, here.others);
  here.others_end = others_.size();
}

void VisibleBoxes::decide(const PixelBox& part, const Ranges& among) {
  for (int y = part[1]; y <= part[3]; ++y) {
    for (int x = part[0]; x <= part[2]; ++x) {
      const PixelBox pixel{x, y, x, y};
      if ((box_ && within(pixel, *box_)) || !shows_owner(x, y, among)) continue;
      box_ = box_ ? around(*box_, pixel) : pixel;
    }
  }
}

void VisibleBoxes::cut(const PixelBox& part, const Ranges& among) {
  const int wide = part[2] - part[0], high = part[3] - part[1];
  if (box_ && meet(part, *box_)) {  // the remainders on each side of the known box
    const PixelBox known = *box_;
    const int left = std::max(part[0], known[0]), right = std::min(part[2], known[2]);
    if (part[0] < known[0]) explore({part[0], part[1], known[0] - 1, part[3]}, among);
    if (part[2] > known[2]) explore({known[2] + 1, part[1], part[2], part[3]}, among);
    if (part[1] < known[1]) explore({left, part[1], right, known[1] - 1}, among);
    if (part[3] > known[3]) explore({left, known[3] + 1, right, part[3]}, among);
    return;
  }
  const std::size_t axis = wide >= high ? 0 : 1;
  const int middle = part[axis] + (wide >= high ? wide : high) / 2;
  PixelBox low = part, far = part;
  low[axis + 2] = middle;
  far[axis] = middle + 1;
  // The half farther from the known box first, since it may make the other one unnecessary.
  const bool far_first = box_ && part[axis + 2] - (*box_)[axis + 2] > (*box_)[axis] - part[axis];
  explore(far_first ? far : low, among);
  explore(far_first ? low : far, among);
}

bool VisibleBoxes::shows_enough(const PixelBox& cover, const Ranges& among) {
  const auto enough = [](std::int64_t seen, std::int64_t silhouette) {
    return seen >= kLeastSeenPixels && kLeastSeenPart * seen >= silhouette;
  };
  // First what is cheap and mostly enough: the parts that were found to show it alone, then a part around the middle.
  if (enough(counted_, pixels_of(cover))) return true;
  const std::int64_t most = std::max<std::int64_t>(kLeastSeenPixels, pixels_of(cover) / kLeastSeenPart + 1);
  counted_ = 0;
  count(middle_of(*box_), among, most);
  if (counted_ >= most) return true;
  counted_ = 0;
  count(*box_, among, most);
  if (counted_ >= most || counted_ < kLeastSeenPixels) return enough(counted_, pixels_of(cover));
  const std::int64_t seen = std::exchange(counted_, 0);
  count(cover, {among.own, among.own_end, among.others, among.others}, kLeastSeenPart * seen + 1);
  return enough(seen, counted_);
}

void VisibleBoxes::count(const PixelBox& part, const Ranges& among, std::int64_t limit) {
  if (counted_ >= limit) return;
  const int wide = part[2] - part[0] + 1, high = part[3] - part[1] + 1;
  if (wide * high <= kFew) {
    for (int y = part[1]; y <= part[3]; ++y) {
      for (int x = part[0]; x <= part[2]; ++x) counted_ += shows_owner(x, y, among) ? 1 : 0;
    }
    return;
  }
  double filled = kNever;
  const Ranges here = narrow(part, among, filled);
  const bool any_own = here.own_end > here.own, any_other = here.others_end > here.others;
  if (any_own && !any_other && filled < kNever) {
    counted_ += pixels_of(part);
  } else if (any_own) {
    const std::size_t axis = wide >= high ? 0 : 1;
    PixelBox low = part, far = part;
    low[axis + 2] = (part[axis] + part[axis + 2]) / 2;
    far[axis] = low[axis + 2] + 1;
    count(low, here, limit);
    count(far, here, limit);
  }
  own_.resize(here.own);
  others_.resize(here.others);
}

bool VisibleBoxes::shows_owner(int x, int y, const Ranges& among) const {
  double first = kNever;
  std::uint32_t shown = 0;
  const PixelBox pixel{x, y, x, y};
  const auto look = [&](const Shown& one) {
    if (one.nearest > first || !meet(one.cover, pixel)) return;
    const double depth = outlines_[one.outline].depth_at(camera_, x, y);
    if (depth == kNever || depth > first || (depth == first && one.outline > shown)) return;
    first = depth;
    shown = one.outline;
  };
  for (std::size_t k = among.own; k < among.own_end; ++k) look(own_[k]);
  for (std::size_t k = among.others; k < among.others_end; ++k) look(others_[k]);
  return first < kNever && outlines_[shown].owner == owner_;
}

}  // namespace unietp
