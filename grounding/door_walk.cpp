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

/// The parts into which a window's free cells fall, of those that hold a cell of which `wanted` is true.
struct Parts {
  static constexpr int kNone = -1;
  std::vector<int> of;  // by the window's index
  std::vector<std::vector<Cell>> cells;

  template <class Wanted>
  Parts(const Window& window, const NavigationGrid& grid, const Wanted& wanted) : of(window.size(), kNone) {
    window.each([&](Cell seed) {
      if (!wanted(seed) || !grid.free(seed) || of[window.index(seed)] != kNone) return;
      const int part = static_cast<int>(cells.size());
      std::vector<Cell> together{seed};
      of[window.index(seed)] = part;
      for (std::size_t at = 0; at < together.size(); ++at) {
        const auto [x, y] = together[at];
        for (const Cell next : {Cell{x + 1, y}, Cell{x - 1, y}, Cell{x, y + 1}, Cell{x, y - 1}}) {
          if (!window.has(next) || !grid.free(next) || of[window.index(next)] != kNone) continue;
          of[window.index(next)] = part;
          together.push_back(next);
        }
      }
      cells.push_back(std::move(together));
    });
  }
};

/// Which cells of the window are reached after the change; nullopt when the window alone does not tell. What leads out
/// of it is reached, when each part of before still leads out in one piece; the rest are pockets that were closed.
std::optional<std::vector<bool>> reached_in(const Window& window, const Walk& before, const NavigationGrid& grid,
                                            Cell start) {
  const auto was_reached = [&](Cell cell) { return before.steps[grid.index(cell)] >= 0; };
  const auto leads_out = [&](Cell cell) {
    return (cell.x == window.from.x && cell.x > 0) || (cell.x == window.to.x && cell.x < grid.width() - 1) ||
           (cell.y == window.from.y && cell.y > 0) || (cell.y == window.to.y && cell.y < grid.height() - 1);
  };
  const Parts parts_before(window, before.grid, was_reached), parts(window, grid, was_reached);
  std::vector<std::size_t> became(parts_before.cells.size(), parts.cells.size());  // which part leads out of each
  std::vector<bool> reached(window.size(), false);
  for (std::size_t part = 0; part < parts.cells.size(); ++part) {
    const auto& cells = parts.cells[part];
    if (std::none_of(cells.begin(), cells.end(), leads_out)) continue;
    for (const Cell cell : cells) {
      reached[window.index(cell)] = true;
      if (!was_reached(cell)) {
        if (leads_out(cell)) return std::nullopt;  // to where none got before
        continue;
      }
      std::size_t& one = became[static_cast<std::size_t>(parts_before.of[window.index(cell)])];
      if (one != parts.cells.size() && one != part) return std::nullopt;
      one = part;
    }
  }
  if (window.has(start) && !reached[window.index(start)]) return std::nullopt;
  return reached;
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
  const auto reached = grid.free(start) ? reached_in(window, *before, grid, start) : std::nullopt;
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
