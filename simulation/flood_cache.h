#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "simulation/walk.h"

namespace unietp {

/// The cells that can be reached from a cell.
struct Flood {
  Digest grid;  // of the navigation grid that it was made for
  CellSet to;
  std::uint64_t number = 0;  // distinguishes it from all others of this cache
};

/// Cache of the last few flood fills and distance fields of one home's grid, since doors that open and close lead back
/// to earlier grids. References are valid until the next call.
class FloodCache {
 public:
  FloodCache() = default;
  /// `start`: results that are known from the beginning; may be null.
  explicit FloodCache(std::shared_ptr<const Walk> start);

  /// The cells that can be reached from `cell`.
  const Flood& around(const NavigationGrid& grid, NavigationGrid::Cell cell);
  /// The fewest steps from a cell to a rectangle of cells, as DistanceField::fewest_to.
  std::int32_t steps(const NavigationGrid& grid, NavigationGrid::Cell from, NavigationGrid::Cell low,
                     NavigationGrid::Cell high, std::int32_t most = DistanceField::kAny);

 private:
  struct Steps {
    Digest grid;
    DistanceField field;
  };
  std::shared_ptr<const Walk> start_;
  std::vector<Flood> floods_;
  std::vector<Steps> fields_;
  std::uint64_t made_ = 0, fields_made_ = 0;
};

}  // namespace unietp
