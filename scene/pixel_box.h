#pragma once

#include <array>

namespace unietp {

/// [x0, y0, x1, y1] in pixels of a picture, x right, y down, both ends included.
using PixelBox = std::array<int, 4>;

/// Pixels that both hold by pixels that one of them holds, 0 to 1; 0 when a box holds none.
double overlap_of(const PixelBox& a, const PixelBox& b);

}  // namespace unietp
