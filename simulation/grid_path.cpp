#include <algorithm>
#include <array>
#include <cmath>

#include "simulation/distance_field.h"
#include "simulation/navigation.h"

namespace unietp {
namespace {

constexpr std::array<std::array<int, 2>, 4> kNeighbors{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

}  // namespace

std::vector<NavigationGrid::Cell> NavigationGrid::path(Cell from, Cell to) const {
  DistanceField field(*this, to);
  std::vector<Cell> cells;
  if (!free(from) || field.fewest_to(from, from) < 0) return cells;
  const auto at = [&](Cell c) { return field.found(c); };
  cells.push_back(from);
  while (at(cells.back()) > 0) {
    for (const auto& d : kNeighbors) {
      const Cell next{cells.back().x + d[0], cells.back().y + d[1]};
      if (free(next) && at(next) == at(cells.back()) - 1) {
        cells.push_back(next);
        break;
      }
    }
  }
  return cells;
}

std::vector<Vec2> NavigationGrid::walk(const Vec2& from, const Vec2& to) const {
  const std::vector<Cell> cells = path(nearest_free(from).value_or(Cell{}), nearest_free(to).value_or(Cell{}));
  if (cells.empty()) return {};
  const auto straight = [&](const Vec2& a, const Vec2& b) {
    const int samples = 1 + static_cast<int>(4 * (b - a).norm() / kCell_m);
    for (int i = 0; i <= samples; ++i) {
      if (!free(cell_at(a + (b - a) * i / samples))) return false;
    }
    return true;
  };
  std::vector<Vec2> points{from};
  for (std::size_t at = 0; at + 1 < cells.size();) {
    std::size_t next = cells.size() - 1;
    while (next > at + 1 && !straight(center(cells[at]), center(cells[next]))) --next;
    at = next;
    points.push_back(at + 1 == cells.size() ? to : center(cells[at]));
  }
  return points;
}

}  // namespace unietp
