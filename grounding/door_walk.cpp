#include "grounding/door_walk.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "simulation/shape.h"

namespace unietp {
namespace {

using Cell = NavigationGrid::Cell;

constexpr int kMargin = 8;  // cells around what can have changed, so that a way around a door is found

/// A part of a grid, both corners in it.
struct Window {
  Cell from, to;
  int width() const { return to.x - from.x + 1; }
  std::size_t size() const { return static_cast<std::size_t>(width()) * static_cast<std::size_t>(to.y - from.y + 1); }
  bool has(Cell cell) const { return cell.x >= from.x && cell.x <= to.x && cell.y >= from.y && cell.y <= to.y; }
  std::size_t index(Cell cell) const {
    return static_cast<std::size_t>(cell.y - from.y) * static_cast<std::size_t>(width()) +
           static_cast<std::size_t>(cell.x - from.x);
  }
  template <class Visit>
  void each(const Visit& visit) const {
    for (int y = from.y; y <= to.y; ++y) {
      for (int x = from.x; x <= to.x; ++x) visit(Cell{x, y});
    }
  }
};

Window around(const NavigationGrid& grid, const Scene& was, const Scene& now, const std::vector<std::size_t>& moved,
              const Profile& profile) {
  Bounds all{Vec3::Constant(1e9), Vec3::Constant(-1e9)};
  for (const std::size_t i : moved) {
    for (const Node* node : {&was.nodes[i], &now.nodes[i]}) {
      const Bounds one = bounds_of(shape_of(*node), node->pose, node->opening);
      all = {all.low.cwiseMin(one.low), all.high.cwiseMax(one.high)};
    }
  }
  const Vec2 reach = Vec2::Constant(profile.body_radius_m + kMargin * NavigationGrid::kCell_m);
  const Cell low = grid.cell_at(all.low.head<2>() - reach), high = grid.cell_at(all.high.head<2>() + reach);
  return {{std::clamp(low.x, 0, grid.width() - 1), std::clamp(low.y, 0, grid.height() - 1)},
          {std::clamp(high.x, 0, grid.width() - 1), std::clamp(high.y, 0, grid.height() - 1)}};
}

/// Which cells of the window are reached after the change; nullopt when the window alone does not tell.
std::optional<std::vector<bool>> reached_in(const Window& window, const Walk& before, const NavigationGrid& grid) {
  const auto was_reached = [&](Cell cell) { return before.steps[grid.index(cell)] >= 0; };
  const auto beyond = [&](Cell cell) {  // a neighbour outside
    return (cell.x == window.from.x && cell.x > 0) || (cell.x == window.to.x && cell.x < grid.width() - 1) ||
           (cell.y == window.from.y && cell.y > 0) || (cell.y == window.to.y && cell.y < grid.height() - 1);
  };
  std::vector<Cell> front;
  std::vector<bool> reached(window.size(), false);
  window.each([&](Cell cell) {
    if (!front.empty() || !was_reached(cell) || !grid.free(cell)) return;
    front.push_back(cell);
    reached[window.index(cell)] = true;
  });
  bool told = !front.empty();
  while (!front.empty()) {
    const Cell cell = front.back();
    front.pop_back();
    told = told && (was_reached(cell) || !beyond(cell));  // else a way out of the window opened
    for (const Cell next :
         {Cell{cell.x + 1, cell.y}, Cell{cell.x - 1, cell.y}, Cell{cell.x, cell.y + 1}, Cell{cell.x, cell.y - 1}}) {
      if (!window.has(next) || !grid.free(next) || reached[window.index(next)]) continue;
      reached[window.index(next)] = true;
      front.push_back(next);
    }
  }
  window.each([&](Cell cell) {  // what was one may be parted now
    told = told && (!was_reached(cell) || !grid.free(cell) || reached[window.index(cell)]);
  });
  return told ? std::optional(std::move(reached)) : std::nullopt;
}

}  // namespace

std::shared_ptr<const Walk> walk_with_doors(const std::shared_ptr<const Walk>& before, const Scene& was,
                                            const Scene& now, const std::vector<std::size_t>& moved,
                                            const Profile& profile) {
  NavigationGrid grid = before->grid;
  for (const std::size_t i : moved) {
    const Shape shape = shape_of(now.nodes[i]);
    grid.update(i, &now.nodes[i], &shape);
  }
  if (grid.digest() == before->grid.digest()) return before;
  const Cell start = grid.cell_at(now.agent.position);
  const Window window = around(grid, was, now, moved, profile);
  const auto reached = grid.free(start) ? reached_in(window, *before, grid) : std::nullopt;
  if (!reached) {
    auto steps = grid.distances(start);
    return std::make_shared<const Walk>(Walk{std::move(grid), std::move(steps)});
  }
  auto walk = std::make_shared<Walk>(Walk{std::move(grid), before->steps});
  window.each([&](Cell cell) {
    std::int32_t& steps = walk->steps[walk->grid.index(cell)];
    steps = (*reached)[window.index(cell)] ? std::max(steps, 0) : -1;
  });
  return walk;
}

}  // namespace unietp
