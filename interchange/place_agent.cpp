#include <algorithm>
#include <cmath>

#include "interchange/draft.h"
#include "simulation/navigation.h"

namespace unietp {
namespace {

using Cell = NavigationGrid::Cell;

/// A free cell of the largest floor that can be walked without a break, the one nearest to that floor's middle.
std::optional<Cell> widest_place(const NavigationGrid& grid) {
  CellSet seen(grid.width(), grid.height());
  std::vector<Cell> widest;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      if (seen.has(x, y) || !grid.free({x, y})) continue;
      const CellSet reached = grid.reached_from({x, y});
      std::vector<Cell> floor;
      for (int v = y; v < grid.height(); ++v) {
        for (int u = 0; u < grid.width(); ++u) {
          if (!reached.has(u, v)) continue;
          seen.set(u, v, true);
          floor.push_back({u, v});
        }
      }
      if (floor.size() > widest.size()) widest = std::move(floor);
    }
  }
  if (widest.empty()) return std::nullopt;
  Vec2 middle = Vec2::Zero();
  for (const Cell& cell : widest) middle += grid.center(cell) / static_cast<double>(widest.size());
  return *std::min_element(widest.begin(), widest.end(), [&](const Cell& a, const Cell& b) {
    return (grid.center(a) - middle).squaredNorm() < (grid.center(b) - middle).squaredNorm();
  });
}

void list_rooms_cut_off(const NavigationGrid& grid, Draft& draft) {
  const CellSet walk = grid.reached_from(grid.cell_at(draft.scene.agent.position));
  for (const Room& room : draft.scene.rooms) {
    bool reached = false;
    for (int y = 0; y < grid.height() && !reached; ++y) {
      for (int x = 0; x < grid.width() && !reached; ++x) {
        reached = walk.has(x, y) && contains(room.polygon, grid.center({x, y}));
      }
    }
    if (!reached) {
      draft.report.issues.push_back(
          {room.id, room.type, ImportReason::CutOff, "the agent's body cannot walk to this room"});
    }
  }
}

}  // namespace

void place_agent(const SourceScene& source, const Profile& profile, Draft& draft) {
  const NavigationGrid grid(draft.scene, profile);
  Agent& agent = draft.scene.agent;
  const bool sound = source.has_agent && source.agent.position.allFinite() && std::isfinite(source.agent.yaw) &&
                     std::isfinite(source.agent.pitch);
  if (sound) agent = source.agent;
  agent.held.clear();
  if (!sound || !grid.free(grid.cell_at(agent.position))) {
    const auto place = widest_place(grid);
    if (place) agent.position = grid.center(*place);
  }
  list_rooms_cut_off(grid, draft);
}

}  // namespace unietp
