#include "grounding/reachability.h"

#include "grounding/floor_plan.h"
#include "simulation/navigation.h"

namespace unietp {
namespace {

std::size_t row_major(const NavigationGrid& grid, NavigationGrid::Cell cell) {
  return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(grid.width()) + static_cast<std::size_t>(cell.x);
}

}  // namespace

bool stand_in_first_room(Scene& scene, const Profile& profile) {
  if (scene.rooms.empty()) return false;
  const NavigationGrid grid(scene, profile);
  const Bounds room = room_bounds(scene.rooms.front(), scene.wall_height);
  const auto cell = grid.nearest_free(((room.low + room.high) / 2).head<2>());
  if (!cell || !contains(scene.rooms.front().polygon, grid.centre(*cell))) return false;
  scene.agent = {};
  scene.agent.position = grid.centre(*cell);
  return true;
}

std::optional<std::string> unreached_room(const Scene& scene, const Profile& profile) {
  const NavigationGrid grid(scene, profile);
  const auto walk = grid.distances(grid.cell_at(scene.agent.position));
  for (const Room& room : scene.rooms) {
    int open = 0, reached = 0;
    for (int y = 0; y < grid.height(); ++y) {
      for (int x = 0; x < grid.width(); ++x) {
        if (!grid.free({x, y}) || !contains(room.polygon, grid.centre({x, y}))) continue;
        ++open;
        if (walk[row_major(grid, {x, y})] >= 0) ++reached;
      }
    }
    if (reached == 0 || 2 * reached < open) return room.id;
  }
  return std::nullopt;
}

std::optional<std::string> unreached_furniture(const Scene& scene, const PhysicsWorld& world, const Profile& profile) {
  const NavigationGrid grid(scene, profile);
  const auto walk = grid.distances(grid.cell_at(scene.agent.position));
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (!scene.nodes[i].movable && !standing_place(scene, world, grid, walk, profile, i)) return scene.nodes[i].id;
  }
  return std::nullopt;
}

}  // namespace unietp
