#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "simulation/navigation.h"

namespace unietp {

/// Distances in steps from one cell of a grid, by breadth-first search that runs only as far as needed for the queries;
/// or completely, for concurrent queries.
class DistanceField {
 public:
  DistanceField(const NavigationGrid& grid, NavigationGrid::Cell from);

  static constexpr std::int32_t kAny = std::numeric_limits<std::int32_t>::max();

  /// The fewest steps (to the four neighbors, over free cells) to a cell of a rectangle, both corners included, which
  /// may lie in part outside of the grid; -1 when no cell can be reached within `most`. Distances end at 65,534 steps,
  /// 6.5 km.
  std::int32_t fewest_to(NavigationGrid::Cell low, NavigationGrid::Cell high, std::int32_t most = kAny);
  /// Completes the search; from then on `fewest_found` equals `fewest_to`.
  void finish();
  /// The same among the cells found so far.
  std::int32_t fewest_found(NavigationGrid::Cell low, NavigationGrid::Cell high, std::int32_t most = kAny) const;
  NavigationGrid::Cell from() const { return from_; }
  /// Steps to a cell that has been found; else -1. Cells are found in order of distance.
  std::int32_t found(NavigationGrid::Cell cell) const {
    const std::uint32_t place = places_[stretch(cell)];
    if (place == 0) return -1;
    const std::uint16_t steps = steps_[place - 1][static_cast<std::size_t>(cell.x) % kStretch];
    return steps == kNoWay ? -1 : steps;
  }

 private:
  static constexpr std::size_t kStretch = 64;
  using Stretch = std::array<std::uint16_t, kStretch>;
  std::size_t stretch(NavigationGrid::Cell cell) const {
    return static_cast<std::size_t>(cell.y) * stretches_ + static_cast<std::size_t>(cell.x) / kStretch;
  }
  void set(NavigationGrid::Cell cell, std::int32_t steps);
  /// One level of the search.
  void go_on();
  bool ended() const { return front_.empty() || far_ + 1 == kNoWay; }

  static constexpr std::uint16_t kNoWay = std::numeric_limits<std::uint16_t>::max();
  NavigationGrid::Cell from_;
  int width_, height_;
  std::size_t stretches_;                    // a row
  CellSet open_;                             // free and not found yet
  std::vector<std::uint32_t> places_;        // by stretch of a row: its place in `steps_`, from 1; 0 for none
  std::vector<Stretch> steps_;               // of the stretches that were reached
  std::vector<NavigationGrid::Cell> front_;  // cells of the last level
  std::vector<NavigationGrid::Cell> next_;   // empty between steps
  std::int32_t far_ = 0;                     // their steps
};

}  // namespace unietp
