#include "simulation/coverage.h"

#include <algorithm>

namespace unietp {
namespace {

constexpr double kSlack = 1e-9;  // far above rounding errors; closer cases are decided by rays

}  // namespace

PartCoverage coverage_of(const Outline& outline, const PixelBox& part, const PartOfImage& middles, bool fills,
                         const Camera& camera) {
  PartCoverage share;
  bool around_covers = true;  // perhaps, the box around a round solid
  if (!fills) {
    if (!meet(outline.cover, part)) return {false, false, 0, 0};
    const auto [least, most] = outline.sides.least_in(middles);
    if (most < -kSlack) return {false, false, 0, 0};
    share.whole = !outline.round && outline.side_count > 0 && least > kSlack;
    around_covers = least > -kSlack && within(part, outline.cover);
  }
  const auto [least, most] = outline.faces.least_in(middles);  // of 1 / depth
  if (outline.face_count > 0 && most < -kSlack) return {false, false, 0, 0};
  share.nearest = std::max(outline.nearest, most > kSlack ? 1 / most - kSlack : 0.0);
  if (!outline.round && least > kSlack) share.farthest = 1 / least + kSlack;
  if (outline.round && around_covers) {  // convex: it covers the part if it covers all four corners
    share.farthest = 0;
    for (const auto& [x, y] : {std::pair{part[0], part[1]}, std::pair{part[2], part[3]}, std::pair{part[0], part[3]},
                               std::pair{part[2], part[1]}}) {
      share.farthest = std::max(share.farthest, outline.depth_at(camera, x, y) + kSlack);
      if (share.farthest == kNever) break;
    }
    share.whole = share.farthest < kNever;
    if (share.whole && outline.target.hollow()) share.farthest = outline.farthest + kSlack;  // deeper between them
  }
  return share;
}

bool certainly_before(const Outline& front, const Outline& behind, const PartOfImage& middles) {
  const auto &faces = front.faces, &other = behind.faces;
  for (Eigen::Index i = 0; i < behind.face_count; ++i) {
    const auto a = other.a[i] - faces.a, b = other.b[i] - faces.b, c = other.c[i] - faces.c;
    const auto most =
        a * middles.middle.x() + b * middles.middle.y() + c + a.abs() * middles.half.x() + b.abs() * middles.half.y();
    if (most.maxCoeff() < -kSlack) return true;
  }
  return false;
}

}  // namespace unietp
