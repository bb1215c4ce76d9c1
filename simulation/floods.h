#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "simulation/navigation.h"
#include "simulation/ripple.h"

namespace unietp {

/// Which cells can be walked to.
struct Flood {
  Digest grid;  // when it was made
  CellSet to;
  std::uint64_t number = 0;  // of this flood among all that were made
};

/// The last few floods and ripples of one home's grid: doors open and shut again, and the way is as it was. What is
/// returned is valid until the next call.
class Floods {
 public:
  /// From a cell.
  const Flood& around(const NavigationGrid& grid, NavigationGrid::Cell cell);
  /// The steps from a cell.
  Ripple& from(const NavigationGrid& grid, NavigationGrid::Cell cell);

 private:
  struct Steps {
    Digest grid;
    NavigationGrid::Cell from;
    Ripple ripple;
  };
  std::vector<Flood> floods_;
  std::vector<Steps> ripples_;
  std::uint64_t made_ = 0, rippled_ = 0;
};

}  // namespace unietp
