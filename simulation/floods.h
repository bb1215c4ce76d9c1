#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "simulation/walk.h"

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
  Floods() = default;
  /// What is known to begin with.
  explicit Floods(std::shared_ptr<const Walk> start);

  /// From a cell.
  const Flood& around(const NavigationGrid& grid, NavigationGrid::Cell cell);
  /// The fewest steps from a cell to one of a rectangle, as Ripple::fewest_to tells.
  std::int32_t steps(const NavigationGrid& grid, NavigationGrid::Cell from, NavigationGrid::Cell low,
                     NavigationGrid::Cell high, std::int32_t most = Ripple::kAny);

 private:
  struct Steps {
    Digest grid;
    Ripple ripple;
  };
  std::shared_ptr<const Walk> start_;
  std::vector<Flood> floods_;
  std::vector<Steps> ripples_;
  std::uint64_t made_ = 0, rippled_ = 0;
};

}  // namespace unietp
