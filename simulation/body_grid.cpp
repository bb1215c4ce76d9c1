#include "simulation/body_grid.h"

#include <algorithm>
#include <cmath>

namespace unietp {

BodyGrid::BodyGrid(const Bounds& around) : origin_(around.low.head<2>()) {
  const Vec2 extent = (around.high - around.low).head<2>().cwiseMax(0.0);
  cell_m_ = std::max(kCell_m, extent.maxCoeff() / kMostCells);
  width_ = 1 + static_cast<int>(extent.x() / cell_m_);
  height_ = 1 + static_cast<int>(extent.y() / cell_m_);
  cells_ = std::vector<std::vector<std::uint32_t>>(place(0, height_));
}

void BodyGrid::insert(std::uint32_t number, const Bounds& bounds) {
  const Range range = range_of(bounds);
  for (int y = range.from_y; y <= range.to_y; ++y) {
    for (int x = range.from_x; x <= range.to_x; ++x) cells_.edit(place(x, y)).push_back(number);
  }
}

void BodyGrid::erase(std::uint32_t number, const Bounds& bounds) {
  const Range range = range_of(bounds);
  for (int y = range.from_y; y <= range.to_y; ++y) {
    for (int x = range.from_x; x <= range.to_x; ++x) std::erase(cells_.edit(place(x, y)), number);
  }
}

}  // namespace unietp
