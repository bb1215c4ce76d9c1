#include "scene/archetype_dimensions.h"

#include <algorithm>
#include <cmath>

namespace unietp {
namespace {

double wall_of(const Vec3& size, double most) { return std::clamp(0.07 * size.minCoeff(), 0.003, most); }

double leg_of(const Vec3& size) { return std::min({0.06, 0.1 * size.x(), 0.1 * size.y()}); }

}  // namespace

TableDimensions table_dimensions(const Vec3& size) { return {std::min(0.04, 0.1 * size.z()), leg_of(size)}; }

SeatDimensions seat_dimensions(const Vec3& size) { return {std::min(0.15, 0.2 * size.y())}; }

BedDimensions bed_dimensions(const Vec3& size) {
  const double height = 0.6 * size.z();
  return {std::min(0.06, 0.2 * size.y()), height, std::min(0.25, 0.45 * height), leg_of(size)};
}

ShelfDimensions shelf_dimensions(const Vec3& size) {
  constexpr double kBoard_m = 0.02, kLowest_m = 0.15, kUsualPitch_m = 0.42;
  if (size.z() < kLowest_m) return {0, kBoard_m, 0};
  const int bays = std::clamp(static_cast<int>(std::lround(size.z() / kUsualPitch_m)), 1, 6);
  return {bays, kBoard_m, (size.z() - kBoard_m) / bays};
}

CabinetDimensions cabinet_dimensions(const Vec3& size) {
  constexpr double kLeastPitch_m = 0.4, kSetBack_m = 0.03;
  const double wall = wall_of(size, 0.02);
  const double low = -size.z() / 2 + wall, high = size.z() / 2 - wall;
  const int bays = std::clamp(static_cast<int>(std::floor((high - low) / kLeastPitch_m)), 1, 5);
  return {wall, bays, (high - low) / bays, kSetBack_m};
}

DrawersDimensions drawers_dimensions(const Vec3& size) {
  const double wall = wall_of(size, 0.02);
  return {wall, std::min(size.z() - 2 * wall, 0.24)};
}

BasinDimensions basin_dimensions(const Vec3& size) {
  const double side = std::min(size.x(), size.y());
  return {std::clamp(0.08 * side, 0.02, 0.06), std::min(0.65 * size.z(), 0.4 * side)};
}

double vessel_wall(const Vec3& size) { return wall_of(size, 0.012); }

}  // namespace unietp
