#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/shared_list.h"
#include "scene/geometry.h"

namespace unietp {

/// Spatial index of bodies in the floor plane: a grid of square cells, each with the numbers of the bodies whose bounds
/// touch it. Homes are flat, so two dimensions separate nearly all bodies. What lies outside the grid is in its border
/// cells. Copies share unchanged cells.
class BodyGrid {
 public:
  BodyGrid() = default;
  /// Covers the given bounds.
  explicit BodyGrid(const Bounds& around);

  /// `erase` takes the same bounds that a body was inserted with.
  void insert(std::uint32_t number, const Bounds& bounds);
  void erase(std::uint32_t number, const Bounds& bounds);
  /// Numbers in the cells that the bounds touch; may repeat a number.
  template <class Visit>
  void visit(const Bounds& bounds, Visit visit) const {
    const Range range = range_of(bounds);
    for (int y = range.from_y; y <= range.to_y; ++y) {
      for (int x = range.from_x; x <= range.to_x; ++x) {
        for (const std::uint32_t number : cell(x, y)) visit(number);
      }
    }
  }
  /// The cells that a segment crosses, in order. `visit(numbers, fraction of the segment at which the cell is entered)`
  /// returns whether to continue.
  template <class Visit>
  void along(const Vec3& from, const Vec3& way, Visit visit) const;

 private:
  struct Range {
    int from_x = 0, to_x = 0, from_y = 0, to_y = 0;
  };
  static constexpr double kCell_m = 0.75;
  static constexpr int kMostCells = 512;  // a side
  int clamped(double cells, int count) const {
    return cells <= 0 ? 0 : cells >= count - 1 ? count - 1 : static_cast<int>(cells);
  }
  Range range_of(const Bounds& bounds) const {
    return {clamped((bounds.low.x() - origin_.x()) / cell_m_, width_),
            clamped((bounds.high.x() - origin_.x()) / cell_m_, width_),
            clamped((bounds.low.y() - origin_.y()) / cell_m_, height_),
            clamped((bounds.high.y() - origin_.y()) / cell_m_, height_)};
  }
  std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  const std::vector<std::uint32_t>& cell(int x, int y) const { return cells_[place(x, y)]; }

  Vec2 origin_ = Vec2::Zero();
  double cell_m_ = kCell_m;
  int width_ = 1, height_ = 1;
  SharedList<std::vector<std::uint32_t>> cells_{{}};
};

template <class Visit>
void BodyGrid::along(const Vec3& from, const Vec3& way, Visit visit) const {
  // Amanatides and Woo (1987), over unbounded cells; those outside are the border's.
  const Vec2 start = (from.head<2>() - origin_) / cell_m_, step = way.head<2>() / cell_m_;
  int at[2], sign[2], last[2];
  double next[2], each[2];
  for (int i = 0; i < 2; ++i) {
    at[i] = static_cast<int>(std::floor(start[i]));
    last[i] = static_cast<int>(std::floor(start[i] + step[i]));
    sign[i] = step[i] < 0 ? -1 : 1;
    each[i] = step[i] == 0 ? 2 : std::abs(1 / step[i]);
    next[i] = step[i] == 0 ? 2 : (at[i] + (sign[i] > 0 ? 1 : 0) - start[i]) / step[i];
  }
  double entered = 0;
  const int crossings = std::abs(last[0] - at[0]) + std::abs(last[1] - at[1]);
  for (int i = 0; i <= crossings; ++i) {
    if (!visit(cell(clamped(at[0], width_), clamped(at[1], height_)), entered)) return;
    const int axis = next[0] < next[1] ? 0 : 1;
    entered = next[axis];
    next[axis] += each[axis];
    at[axis] += sign[axis];
  }
}

}  // namespace unietp
