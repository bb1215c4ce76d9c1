#pragma once

#include "simulation/outline.h"

namespace unietp {

/// Whether a box lies in another one.
inline bool within(const PixelBox& inner, const PixelBox& outer) {
  return inner[0] >= outer[0] && inner[1] >= outer[1] && inner[2] <= outer[2] && inner[3] <= outer[3];
}

/// Whether two boxes share a pixel.
inline bool meet(const PixelBox& a, const PixelBox& b) {
  return a[0] <= b[2] && b[0] <= a[2] && a[1] <= b[3] && b[1] <= a[3];
}

/// How a solid covers a part of the image, as far as its outline tells: pixels near a bound are left open.
struct PartCoverage {
  bool any = true;                        // false: certainly no pixel
  bool whole = true;                      // true: certainly every pixel
  double nearest = 0, farthest = kNever;  // depth range of the visible part, meters
};

/// `middles`: those of the part's pixels. `fills`: the solid is known to cover every pixel.
PartCoverage coverage_of(const Outline& outline, const PixelBox& part, const PartOfImage& middles, bool fills,
                         const Camera& camera);

/// Whether a box that covers a part is nearer than another solid in every pixel: one face of the solid behind is
/// everywhere deeper than every face in front.
bool certainly_before(const Outline& front, const Outline& behind, const PartOfImage& middles);

}  // namespace unietp
