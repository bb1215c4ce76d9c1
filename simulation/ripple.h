#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "simulation/navigation.h"

namespace unietp {

/// The steps from one cell of a grid to the others, found as far as they are asked for: what is near is found without
/// a look at a whole street. Or all at once, for many to ask.
class Ripple {
 public:
  Ripple(const NavigationGrid& grid, NavigationGrid::Cell from);

  static constexpr std::int32_t kAny = std::numeric_limits<std::int32_t>::max();

  /// The fewest steps (to the four neighbours, over free cells) to a cell of a rectangle, both corners included, which
  /// may lie in part outside of the grid; -1 when there is no way of at most so many to any. No way is farther than
  /// 65,534 steps, 6.5 km.
  std::int32_t fewest_to(NavigationGrid::Cell low, NavigationGrid::Cell high, std::int32_t most = kAny);
  /// Finds all; from then on `fewest_found` answers as `fewest_to` does.
  void finish();
  /// Of what has been found.
  std::int32_t fewest_found(NavigationGrid::Cell low, NavigationGrid::Cell high, std::int32_t most = kAny) const;
  NavigationGrid::Cell from() const { return from_; }
  /// To a cell of the grid, when that has been found; else -1. All that are nearer have been found then, too.
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
  /// One step more, from all that were found last.
  void go_on();
  bool ended() const { return front_.empty() || far_ + 1 == kNoWay; }

  static constexpr std::uint16_t kNoWay = std::numeric_limits<std::uint16_t>::max();
  NavigationGrid::Cell from_;
  int width_, height_;
  std::size_t stretches_;                    // a row
  CellSet open_;                             // free, and not found yet
  std::vector<std::uint32_t> places_;        // by stretch of a row: its place in `steps_`, from 1; 0 for none
  std::vector<Stretch> steps_;               // of the stretches that were come to
  std::vector<NavigationGrid::Cell> front_;  // those that were found last
  std::vector<NavigationGrid::Cell> next_;   // empty between steps
  std::int32_t far_ = 0;                     // their steps
};

}  // namespace unietp
