#include "simulation/floods.h"

#include <algorithm>

namespace unietp {

template <class Fits>
const Flood& Floods::found(const NavigationGrid& grid, NavigationGrid::Cell cell, const Fits& fits) {
  constexpr std::size_t kMost = 8;
  const auto known = std::find_if(kept_.begin(), kept_.end(), [&](const Flood& flood) {
    return flood.grid == grid.digest() && (flood.from == cell || fits(flood));
  });
  if (known != kept_.end()) return *known;
  Flood& place = kept_.size() < kMost ? kept_.emplace_back() : kept_[made_ % kMost];
  place = {grid.digest(), cell, grid.distances(cell), made_++};
  return place;
}

const Flood& Floods::from(const NavigationGrid& grid, NavigationGrid::Cell cell) {
  return found(grid, cell, [](const Flood&) { return false; });
}

const Flood& Floods::around(const NavigationGrid& grid, NavigationGrid::Cell cell) {
  const bool free = grid.free(cell);
  return found(grid, cell, [&](const Flood& flood) { return free && flood.to[grid.index(cell)] >= 0; });
}

}  // namespace unietp
