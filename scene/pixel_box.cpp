#include "scene/pixel_box.h"

#include <algorithm>

namespace unietp {
namespace {

double area(const PixelBox& box) {  // in double: a box may be as large as integers go
  const double wide = static_cast<double>(box[2]) - box[0] + 1, high = static_cast<double>(box[3]) - box[1] + 1;
  return wide > 0 && high > 0 ? wide * high : 0;
}

}  // namespace

double overlap_of(const PixelBox& a, const PixelBox& b) {
  const PixelBox common{std::max(a[0], b[0]), std::max(a[1], b[1]), std::min(a[2], b[2]), std::min(a[3], b[3])};
  const double both = area(common), either = area(a) + area(b) - both;
  return area(a) > 0 && area(b) > 0 ? both / either : 0;
}

}  // namespace unietp
