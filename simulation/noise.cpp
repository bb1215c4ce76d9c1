#include "simulation/noise.h"

#include <array>
#include <cmath>
#include <limits>

namespace unietp {
namespace {

using Cell = Eigen::Vector3i;

Cell cell_of(const Vec3& at) {
  return {static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y())),
          static_cast<int>(std::floor(at.z()))};
}

}  // namespace

std::uint32_t number_of(std::string_view text) {
  std::uint32_t hash = 2166136261U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  return hash;
}

double hashed(int x, int y, int z, std::uint32_t seed) {
  std::uint32_t h = seed + static_cast<std::uint32_t>(x) * 0x8da6b343U + static_cast<std::uint32_t>(y) * 0xd8163841U +
                    static_cast<std::uint32_t>(z) * 0xcb1ab31fU;
  h = (h ^ (h >> 15)) * 0x2c1b3c6dU;
  h = (h ^ (h >> 12)) * 0x297a2d39U;
  h ^= h >> 15;
  return static_cast<double>(h) / 4294967296.0;
}

double noise(const Vec3& at, std::uint32_t seed) {
  const Cell c = cell_of(at);
  const Vec3 part = at - c.cast<double>();
  const auto smooth = [](double t) { return t * t * (3 - 2 * t); };
  const double x = smooth(part.x()), y = smooth(part.y()), z = smooth(part.z());
  const auto along = [&](int dy, int dz) {
    const double low = hashed(c.x(), c.y() + dy, c.z() + dz, seed);
    return low + x * (hashed(c.x() + 1, c.y() + dy, c.z() + dz, seed) - low);
  };
  const auto across = [&](int dz) {
    const double low = along(0, dz);
    return low + y * (along(1, dz) - low);
  };
  const double low = across(0);
  return low + z * (across(1) - low);
}

double rough_noise(const Vec3& at, std::uint32_t seed) { return (2 * noise(at, seed) + noise(2.7 * at, seed + 1)) / 3; }

CellAt cell_at(const Vec3& at, std::uint32_t seed) {
  const Cell home = cell_of(at);
  double nearest = std::numeric_limits<double>::infinity(), second = nearest;
  CellAt found;
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dz = -1; dz <= 1; ++dz) {
        const Cell c = home + Cell(dx, dy, dz);
        const auto part = [&](std::uint32_t axis) { return hashed(c.x(), c.y(), c.z(), seed + 11 * axis); };
        const double away = (c.cast<double>() + Vec3(part(1), part(2), part(3)) - at).squaredNorm();
        if (away < nearest) {
          second = nearest;
          nearest = away;
          found.number = part(4);
        } else if (away < second) {
          second = away;
        }
      }
    }
  }
  found.to_middle = std::sqrt(nearest);
  found.to_border = std::sqrt(second) - found.to_middle;
  return found;
}

double wave(double value) {
  const double part = value - std::floor(value);
  return part < 0.5 ? 2 * part : 2 - 2 * part;
}

}  // namespace unietp
