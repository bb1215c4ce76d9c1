#include "simulation/visible_box.h"

namespace unietp {
namespace {

constexpr double kSlack = 1e-9;  // far more than the sums err by; what is nearer than this is left to the rays

bool within(const PixelBox& inner, const PixelBox& outer) {
  return inner[0] >= outer[0] && inner[1] >= outer[1] && inner[2] <= outer[2] && inner[3] <= outer[3];
}

PixelBox common_part(const PixelBox& a, const PixelBox& b) {
  return {std::max(a[0], b[0]), std::max(a[1], b[1]), std::min(a[2], b[2]), std::min(a[3], b[3])};
}

/// What a part of the image has of a solid.
struct Share {
  bool any = true;                        // false: certainly nothing
  bool whole = true;                      // true: certainly every pixel
  double nearest = 0, farthest = kNever;  // depth of what shows, between these
};

Share share_of(const Outline& outline, const PixelBox& part, const Camera& camera) {
  Share share;
  if (!meet(outline.cover, part)) return {false, false, 0, 0};
  share.whole = !outline.round && outline.side_count > 0;
  const PartOfImage middles(part);
  for (std::size_t i = 0; i < outline.side_count; ++i) {
    const auto [least, most] = outline.sides[i].range(middles);
    if (most < -kSlack) return {false, false, 0, 0};
    share.whole = share.whole && least > kSlack;
  }
  double most = kNever, least = kNever;  // of 1 / depth
  for (std::size_t i = 0; i < outline.face_count; ++i) {
    const auto [low, high] = outline.faces[i].range(middles);
    most = std::min(most, high);
    least = std::min(least, low);
  }
  if (outline.face_count > 0 && most < -kSlack) return {false, false, 0, 0};
  share.nearest = std::max(outline.nearest, most > kSlack ? 1 / most - kSlack : 0.0);
  if (!outline.round && least > kSlack) share.farthest = 1 / least + kSlack;
  if (outline.round) {  // convex: it fills the part when it shows in all four corners
    share.farthest = 0;
    for (const auto& [x, y] : {std::pair{part[0], part[1]}, std::pair{part[2], part[3]}, std::pair{part[0], part[3]},
                               std::pair{part[2], part[1]}}) {
      share.farthest = std::max(share.farthest, outline.depth_at(camera, x, y) + kSlack);
      if (share.farthest == kNever) break;
    }
    share.whole = share.farthest < kNever;
  }
  return share;
}

}  // namespace

std::optional<PixelBox> VisibleBoxes::of(std::int32_t owner) {
  owner_ = owner;
  box_.reset();
  std::optional<PixelBox> cover;
  double farthest = 0;
  for (const Outline& outline : outlines_) {
    if (outline.owner != owner) continue;
    cover = cover ? around(*cover, outline.cover) : outline.cover;
    farthest = std::max(farthest, outline.farthest);
  }
  if (!cover) return std::nullopt;
  stack_.clear();
  for (std::size_t i = 0; i < outlines_.size(); ++i) {
    if (outlines_[i].nearest <= farthest && meet(outlines_[i].cover, *cover)) stack_.push_back(i);
  }
  asked_ = stack_.size();
  explore(*cover, 0, asked_);
  return box_;
}

void VisibleBoxes::probe_corners(std::size_t begin, std::size_t end) {
  const std::span<const std::size_t> among = std::span(stack_).subspan(begin, end - begin);
  // Left, up, right, down: of all its solids the one that reaches farthest.
  for (std::size_t side = 0; side < 4; ++side) {
    const Outline* farthest = nullptr;
    const auto reach = [side](const Outline& outline) {
      const double at = outline.extremes[side][side % 2 == 0 ? 0 : 1];
      return side < 2 ? -at : at;
    };
    for (const std::size_t i : among) {
      if (outlines_[i].owner != owner_) continue;
      if (farthest == nullptr || reach(outlines_[i]) > reach(*farthest)) farthest = &outlines_[i];
    }
    probe(*farthest, farthest->extremes[side], among);
  }
}

void VisibleBoxes::probe(const Outline& outline, const Vec2& corner, std::span<const std::size_t> among) {
  const PixelBox& cover = outline.cover;
  const Vec2 middle = Vec2(cover[0] + cover[2] + 1, cover[1] + cover[3] + 1) / 2;
  for (const double inwards : {0.7, 2.0}) {  // pixels: a corner may be sharper than one
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

void VisibleBoxes::explore(const PixelBox& whole, std::size_t begin, std::size_t end) {
  const auto part = worth_exploring(whole, begin, end);
  if (part) explore_part(*part, begin, end);
}

std::optional<PixelBox> VisibleBoxes::worth_exploring(const PixelBox& part, std::size_t begin, std::size_t end) const {
  std::optional<PixelBox> own;
  for (std::size_t k = begin; k < end; ++k) {
    const Outline& outline = outlines_[stack_[k]];
    if (outline.owner != owner_ || !meet(outline.cover, part)) continue;
    const PixelBox common = common_part(outline.cover, part);
    own = own ? around(*own, common) : common;
  }
  if (!own || (box_ && within(*own, *box_))) return std::nullopt;
  return own;
}

void VisibleBoxes::explore_part(const PixelBox& part, std::size_t begin, std::size_t end) {
  // Those that have a share of the part, and how deep the first that fills it lies.
  const std::size_t mine = stack_.size();
  double filled = kNever;
  nearest_.clear();
  for (std::size_t k = begin; k < end; ++k) {
    const std::size_t i = stack_[k];
    const Share share = share_of(outlines_[i], part, camera_);
    if (!share.any || share.nearest > filled) continue;
    if (share.whole) filled = std::min(filled, share.farthest);
    stack_.push_back(i);
    nearest_.push_back(share.nearest);
  }
  std::size_t kept = mine;
  bool any_own = false, any_other = false;
  for (std::size_t k = mine; k < stack_.size(); ++k) {
    if (nearest_[k - mine] > filled) continue;
    const bool own = outlines_[stack_[k]].owner == owner_;
    any_own = any_own || own;
    any_other = any_other || !own;
    stack_[kept++] = stack_[k];
  }
  stack_.resize(kept);
  if (any_own && !any_other && filled < kNever) {
    box_ = box_ ? around(*box_, part) : part;
  } else if (any_own) {
    if (mine == asked_) probe_corners(mine, kept);  // of the whole that may show it
    halve(part, mine, kept);
  }
  stack_.resize(mine);
}

void VisibleBoxes::halve(const PixelBox& part, std::size_t begin, std::size_t end) {
  const int wide = part[2] - part[0], high = part[3] - part[1];
  if (wide == 0 && high == 0) {
    if (!shows_owner(part[0], part[1], std::span(stack_).subspan(begin, end - begin))) return;
    box_ = box_ ? around(*box_, part) : part;
    return;
  }
  const std::size_t axis = wide >= high ? 0 : 1;
  const int middle = part[axis] + (wide >= high ? wide : high) / 2;
  PixelBox low = part, far = part;
  low[axis + 2] = middle;
  far[axis] = middle + 1;
  // The half that reaches farther out of what is known first: it may spare the other.
  const bool far_first = box_ && part[axis + 2] - (*box_)[axis + 2] > (*box_)[axis] - part[axis];
  explore(far_first ? far : low, begin, end);
  explore(far_first ? low : far, begin, end);
}

bool VisibleBoxes::shows_owner(int x, int y, std::span<const std::size_t> among) const {
  double first = kNever;
  std::int32_t shown = -1;
  const PixelBox pixel{x, y, x, y};
  for (const std::size_t i : among) {  // in the list's order
    if (!meet(outlines_[i].cover, pixel) || outlines_[i].nearest >= first) continue;
    const double depth = outlines_[i].depth_at(camera_, x, y);
    if (depth >= first) continue;
    first = depth;
    shown = outlines_[i].owner;
  }
  return first < kNever && shown == owner_;
}

}  // namespace unietp
