#pragma once

#include <cstdint>
#include <vector>

#include "simulation/navigation.h"

namespace unietp {

/// Which cells can be walked to and in how many steps.
struct Flood {
  Digest grid;  // when it was made
  NavigationGrid::Cell from;
  std::vector<std::int32_t> to;  // steps by the grid's index, -1 where no one gets
  std::uint64_t number = 0;      // of this flood among all that were made
};

/// The last few floods of one home's grid: doors open and shut again, and the way is as it was. What is returned is
/// valid until the next call.
class Floods {
 public:
  const Flood& from(const NavigationGrid& grid, NavigationGrid::Cell cell);
  /// From there or from any cell that can be walked to from there: its steps tell where one gets and no more.
  const Flood& around(const NavigationGrid& grid, NavigationGrid::Cell cell);

 private:
  template <class Fits>
  const Flood& found(const NavigationGrid& grid, NavigationGrid::Cell cell, const Fits& fits);

  std::vector<Flood> kept_;
  std::uint64_t made_ = 0;
};

}  // namespace unietp
