#pragma once

#include <cstdint>
#include <string_view>

#include "scene/geometry.h"

namespace unietp {

// Random-looking functions of a point. They use integers, sums, products and roots alone, so that equal arguments give
// equal bits on every machine.

/// FNV-1a.
std::uint32_t number_of(std::string_view text);
/// In [0, 1), of whole numbers.
double hashed(int x, int y, int z, std::uint32_t seed);
/// Value noise: smooth, in [0, 1], about one hill for each unit of length.
double noise(const Vec3& at, std::uint32_t seed);
/// Two octaves of it, in [0, 1].
double rough_noise(const Vec3& at, std::uint32_t seed);

/// Cells around one random point in each unit cube (Worley, 1996).
struct CellAt {
  double to_border = 0;  // distance to the second nearest point less that to the nearest one; 0 on a border
  double to_middle = 0;  // distance to the nearest point
  double number = 0;     // of the cell, in [0, 1)
};
CellAt cell_at(const Vec3& at, std::uint32_t seed);

/// 0 up to `low`, 1 from `high`, a smooth cubic between them.
inline double ramp(double low, double high, double value) {
  const double t = value <= low ? 0 : value >= high ? 1 : (value - low) / (high - low);
  return t * t * (3 - 2 * t);
}
/// A triangle wave of period 1 in [0, 1], 0 at whole numbers.
double wave(double value);

}  // namespace unietp
