#include "simulation/flood_cache.h"

#include <algorithm>
#include <utility>

namespace unietp {
namespace {

constexpr std::size_t kMostKept = 8;

/// Adds an entry, replacing the oldest when the list is full. `before`: the number of entries added so far.
template <class T>
T& keep(std::vector<T>& list, std::uint64_t before, T one) {
  if (list.size() < kMostKept) return list.emplace_back(std::move(one));
  return list[before % kMostKept] = std::move(one);
}

}  // namespace

FloodCache::FloodCache(std::shared_ptr<const Walk> start) : start_(std::move(start)) {
  floods_.push_back({start_->grid.digest(), start_->reached, made_++});
}

const Flood& FloodCache::around(const NavigationGrid& grid, NavigationGrid::Cell cell) {
  const auto known = std::find_if(floods_.begin(), floods_.end(), [&](const Flood& flood) {
    return flood.grid == grid.digest() && flood.to.has(cell.x, cell.y);
  });
  if (known != floods_.end()) return *known;
  const std::uint64_t number = made_++;
  CellSet to = start_ != nullptr ? grid.reached_from(cell, start_->grid, start_->reached) : grid.reached_from(cell);
  return keep(floods_, number, Flood{grid.digest(), std::move(to), number});
}

std::int32_t FloodCache::steps(const NavigationGrid& grid, NavigationGrid::Cell from, NavigationGrid::Cell low,
                               NavigationGrid::Cell high, std::int32_t most) {
  const DistanceField* all = start_ != nullptr ? start_->steps.get() : nullptr;
  if (all != nullptr && all->from() == from && start_->grid.digest() == grid.digest())
    return all->fewest_found(low, high, most);
  const auto known = std::find_if(fields_.begin(), fields_.end(), [&](const Steps& steps) {
    return steps.grid == grid.digest() && steps.field.from() == from;
  });
  DistanceField& field = known != fields_.end()
                             ? known->field
                             : keep(fields_, fields_made_++, Steps{grid.digest(), DistanceField(grid, from)}).field;
  return field.fewest_to(low, high, most);
}

}  // namespace unietp
