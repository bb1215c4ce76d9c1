#include "simulation/first_solids.h"

#include <algorithm>
#include <optional>

#include "simulation/coverage.h"

namespace unietp {
namespace {

/// A solid that may be visible in a part of the image.
struct Shown {
  std::uint32_t outline = 0;
  bool fills = false;  // a box that certainly covers the part
  double nearest = 0;  // lower bound of its depth in the part
};

class Splitter {
 public:
  Splitter(const std::vector<Solid>& solids, const Camera& camera)
      : camera_(camera), hits_(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height)) {
    outlines_.reserve(solids.size());
    for (std::size_t i = 0; i < solids.size(); ++i) {
      auto outline = outline_of(solids[i], camera);
      if (!outline) continue;
      outlines_.push_back(*outline);
      solid_of_.push_back(static_cast<std::int32_t>(i));
    }
  }

  std::vector<PixelHit> hits() {
    for (std::uint32_t i = 0; i < outlines_.size(); ++i) shown_.push_back({i, false, outlines_[i].nearest});
    std::sort(shown_.begin(), shown_.end(), [](const Shown& a, const Shown& b) {
      return std::pair(a.nearest, a.outline) < std::pair(b.nearest, b.outline);
    });
    split({0, 0, camera_.width - 1, camera_.height - 1}, 0, shown_.size());
    return std::move(hits_);
  }

 private:
  /// Those from `begin` to `end` on the stack are the ones that may be visible in the part.
  void split(const PixelBox& part, std::size_t begin, std::size_t end) {
    constexpr int kFew = 25;  // pixels
    const std::size_t from = shown_.size();
    const bool whole = gather(part, begin, end);
    const int wide = part[2] - part[0] + 1, high = part[3] - part[1] + 1;
    if (shown_.size() == from) {
      // nothing
    } else if (whole) {
      fill(part, outlines_[shown_.back().outline]);
    } else if (wide * high <= kFew) {
      decide(part, from, shown_.size());
    } else {
      const std::size_t axis = wide >= high ? 0 : 1, until = shown_.size();
      PixelBox low = part, far = part;
      low[axis + 2] = (part[axis] + part[axis + 2]) / 2;
      far[axis] = low[axis + 2] + 1;
      split(low, from, until);
      split(far, from, until);
    }
    shown_.resize(from);
  }

  /// Pushes those of them that may be visible in the part; true if there is one alone, which covers it.
  bool gather(const PixelBox& part, std::size_t begin, std::size_t end) {
    const std::size_t from = shown_.size();
    const PartOfImage middles(part);
    double filled = kNever;  // the depth behind which nothing is visible
    bool whole = false;      // of the last one
    for (std::size_t k = begin; k < end; ++k) {
      const Shown above = shown_[k];
      if (above.nearest > filled) continue;
      const Outline& outline = outlines_[above.outline];
      const PartCoverage share = coverage_of(outline, part, middles, above.fills, camera_);
      if (!share.any || share.nearest > filled) continue;
      if (share.whole) filled = std::min(filled, share.farthest);
      whole = share.whole;
      shown_.push_back({above.outline, share.whole && !outline.round, share.nearest});
    }
    const std::size_t found = shown_.size() - from;
    drop(from, [filled](const Shown& one) { return one.nearest > filled; });
    for (std::size_t k = from; k < shown_.size() && shown_.size() > from + 1; ++k) {
      if (!shown_[k].fills) continue;
      const std::uint32_t front = shown_[k].outline;
      drop(from, [&](const Shown& one) {
        return one.outline != front && certainly_before(outlines_[front], outlines_[one.outline], middles);
      });
    }
    if (shown_.size() != from + 1) return false;
    return shown_.back().fills || (found == 1 && whole);
  }
  template <class Hidden>
  void drop(std::size_t from, Hidden hidden) {
    shown_.erase(std::remove_if(shown_.begin() + static_cast<std::ptrdiff_t>(from), shown_.end(), hidden),
                 shown_.end());
  }

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(camera_.width) + static_cast<std::size_t>(x);
  }
  RayEntry entry(const Outline& outline, const Vec3& direction) const {
    return enter(outline.target, outline.from, outline.target.to_own * direction);
  }
  std::int32_t number_of(const Outline& outline) const {
    return solid_of_[static_cast<std::size_t>(&outline - outlines_.data())];
  }

  /// A part that one solid covers. Where its corners show one flat face of a convex solid, the plane of that face; but
  /// where a ray goes on through glass, exactly what it meets.
  void fill(const PixelBox& part, const Outline& outline) {
    const auto at = [&](int x, int y) { return entry(outline, camera_.ray(x + 0.5, y + 0.5)); };
    const RayEntry corner = at(part[0], part[1]);
    const auto flat = [&](int x, int y) { return at(x, y).normal == corner.normal; };
    const bool plane = !outline.clear && !outline.target.hollow() && flat(part[2], part[1]) && flat(part[0], part[3]) &&
                       flat(part[2], part[3]);
    PixelHit hit{number_of(outline), corner.along, outline.target.normal_in_w(corner.normal)};
    const double away = corner.along * camera_.ray(part[0] + 0.5, part[1] + 0.5).dot(hit.normal);
    Vec3 last = corner.normal;
    for (int y = part[1]; y <= part[3]; ++y) {
      for (int x = part[0]; x <= part[2]; ++x) {
        const Vec3 direction = camera_.ray(x + 0.5, y + 0.5);
        if (plane) {
          hit.depth = away / direction.dot(hit.normal);
        } else {
          const RayEntry met = entry(outline, direction);
          hit.depth = met.along;
          if (met.normal != last) hit.normal = outline.target.normal_in_w(last = met.normal);
        }
        hits_[index(x, y)] = hit;
      }
    }
  }

  /// Pixel by pixel among those from `begin` to `end`.
  void decide(const PixelBox& part, std::size_t begin, std::size_t end) {
    for (int y = part[1]; y <= part[3]; ++y) {
      for (int x = part[0]; x <= part[2]; ++x) {
        const Vec3 direction = camera_.ray(x + 0.5, y + 0.5);
        RayEntry first;
        std::uint32_t shown = 0;
        for (std::size_t k = begin; k < end; ++k) {
          const Shown& one = shown_[k];
          const Outline& outline = outlines_[one.outline];
          if (one.nearest > first.along || !meet(outline.cover, {x, y, x, y})) continue;
          const RayEntry met = entry(outline, direction);
          if (met.along == kNever || met.along > first.along || (met.along == first.along && one.outline > shown))
            continue;
          first = met;
          shown = one.outline;
        }
        if (first.along == kNever) continue;
        const Outline& outline = outlines_[shown];
        hits_[index(x, y)] = {number_of(outline), first.along, outline.target.normal_in_w(first.normal)};
      }
    }
  }

  const Camera& camera_;
  std::vector<Outline> outlines_;
  std::vector<std::int32_t> solid_of_;  // of each outline
  std::vector<Shown> shown_;            // those that may be visible in the parts on the recursion path
  std::vector<PixelHit> hits_;
};

}  // namespace

std::vector<PixelHit> first_solids(const std::vector<Solid>& solids, const Camera& camera) {
  return Splitter(solids, camera).hits();
}

}  // namespace unietp
