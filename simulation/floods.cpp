#include "simulation/floods.h"

#include <algorithm>

namespace unietp {
namespace {

constexpr std::size_t kMostKept = 8;

/// Puts one more in the list, in the place of the oldest when it is full. `before`: how many were put in.
template <class T>
T& keep(std::vector<T>& list, std::uint64_t before, T one) {
  if (list.size() < kMostKept) return list.emplace_back(std::move(one));
  return list[before % kMostKept] = std::move(one);
}

}  // namespace

const Flood& Floods::around(const NavigationGrid& grid, NavigationGrid::Cell cell) {
  const auto known = std::find_if(floods_.begin(), floods_.end(), [&](const Flood& flood) {
    return flood.grid == grid.digest() && flood.to.has(cell.x, cell.y);
  });
  if (known != floods_.end()) return *known;
  const std::uint64_t number = made_++;
  return keep(floods_, number, Flood{grid.digest(), grid.reached_from(cell), number});
}

Ripple& Floods::from(const NavigationGrid& grid, NavigationGrid::Cell cell) {
  const auto known = std::find_if(ripples_.begin(), ripples_.end(), [&](const Steps& steps) {
    return steps.grid == grid.digest() && steps.from == cell;
  });
  if (known != ripples_.end()) return known->ripple;
  return keep(ripples_, rippled_++, Steps{grid.digest(), cell, Ripple(grid, cell)}).ripple;
}

}  // namespace unietp
