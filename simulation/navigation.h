#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/shared_list.h"
#include "scene/scene.h"
#include "simulation/cell_set.h"
#include "simulation/digest.h"
#include "simulation/footprint.h"
#include "simulation/profile.h"

namespace unietp {

/// Where a body of the profile's radius can stand: a grid of kCell_m over the rooms' bounds. A cell is free when a disc
/// of the body's radius around its center meets no wall and no solid between 5 cm and the body's height.
class NavigationGrid {
 public:
  static constexpr double kCell_m = 0.1;
  struct Cell {
    std::int32_t x = 0, y = 0;
    bool operator==(const Cell&) const = default;
  };

  NavigationGrid(const Scene& scene, const Profile& profile);
  /// Replaces node i, or removes it when `node` is nullptr. Equal to a newly built grid.
  void update(std::size_t i, const Node* node, const Shape* shape);
  /// Of all blockers: grids of one home with equal digests have equal free cells.
  const Digest& digest() const { return digest_; }

  /// Whether the body's middle may be there.
  bool free(Cell cell) const { return free_.has(cell.x, cell.y); }
  const CellSet& free_cells() const { return free_; }
  /// The cell that holds a point of the floor plan, and the middle of a cell. Meters, W.
  Cell cell_at(const Vec2& point) const {
    const Vec2 cells = (point - origin_) / kCell_m;
    return {static_cast<std::int32_t>(std::floor(cells.x())), static_cast<std::int32_t>(std::floor(cells.y()))};
  }
  Vec2 center(Cell cell) const { return origin_ + Vec2((cell.x + 0.5) * kCell_m, (cell.y + 0.5) * kCell_m); }
  int width() const { return width_; }  // cells
  int height() const { return height_; }

  /// The cells that the body can walk to by steps to the four neighbors, `from` included; empty when `from` is not
  /// free.
  CellSet reached_from(Cell from) const { return free_.connected_to(from.x, from.y); }
  /// The same, faster for a grid that differs little from `before`; `reached`: the cells reached from `from` there.
  CellSet reached_from(Cell from, const NavigationGrid& before, const CellSet& reached) const {
    return free_.connected_to(from.x, from.y, before.free_, reached);
  }
  /// The free cell nearest to a point, ties by row then column.
  std::optional<Cell> nearest_free(const Vec2& point) const;
  /// Cells of a shortest walk, both ends included; empty when there is none.
  std::vector<Cell> path(Cell from, Cell to) const;
  /// The shortest path, straightened wherever a straight line stays on free cells.
  /// Both points included; empty when there is no way.
  std::vector<Vec2> walk(const Vec2& from, const Vec2& to) const;

 private:
  void open_floor(Cell cell);
  void count(const FloorFootprint& shadow, int by);
  int width_ = 0, height_ = 0;
  Vec2 origin_ = Vec2::Zero();
  double body_radius_ = 0, body_height_ = 0;
  static constexpr std::size_t kStretch = 64;
  using Stretch = std::array<std::uint16_t, kStretch>;
  std::size_t stretch(Cell cell) const {
    return static_cast<std::size_t>(cell.y) * stretches_ + static_cast<std::size_t>(cell.x) / kStretch;
  }
  std::size_t stretches_ = 0;     // a row
  SharedList<Stretch> blockers_;  // by cell, in stretches of a row: solids over it, and 1 outside of all rooms
  SharedList<std::vector<FloorFootprint>> footprints_;  // by node: what of it is counted
  CellSet free_;                                        // those that nothing blocks
  Digest digest_;                                       // the sum over nodes
};

}  // namespace unietp
