#include "grounding/reachability.h"

#include <algorithm>
#include <cmath>

#include "grounding/floor_plan.h"
#include "simulation/standing.h"

namespace unietp {
namespace {

constexpr double kReachReserve_m = 0.02;
constexpr double kInsideTheDoor_m = 0.5;

/// True when a place right before the middle of the piece will do, as it does for most.
bool reached_from_the_front(const Scene& scene, const PhysicsWorld& world, const Profile& profile, const Walk& walk,
                            std::size_t index) {
  const NavigationGrid& grid = walk.grid;
  const Node& node = scene.nodes[index];
  for (double away = profile.body_radius_m + 0.15; away < profile.reach_m; away += 0.25) {
    const Vec3 spot = node.pose * Vec3(0, -node.size.y() / 2 - away, 0);
    const auto cell = grid.cell_at(spot.head<2>());
    if (!walk.reached.has(cell.x, cell.y)) continue;
    const Vec2 at = grid.center(cell);
    if (reach_distance(node, at, profile) > profile.reach_m - kReachReserve_m) continue;
    if (in_door_sweep(node, at, profile)) continue;
    if (sees(scene, world, profile, at, index)) return true;
  }
  return false;
}

/// Most rooms are, and a point in one is told at a glance.
bool is_rectangle(const Room& room, const Bounds& bounds) {
  return room.polygon.size() == 4 && std::all_of(room.polygon.begin(), room.polygon.end(), [&](const Vec2& corner) {
           return (corner.x() == bounds.low.x() || corner.x() == bounds.high.x()) &&
                  (corner.y() == bounds.low.y() || corner.y() == bounds.high.y());
         });
}

/// The agent can walk to most of the room's free floor, of which there is some.
bool is_reached(const Scene& scene, const Room& room, const Walk& walk) {
  const NavigationGrid& grid = walk.grid;
  const Bounds bounds = room_bounds(room, scene.wall_height);
  const auto from = grid.cell_at(bounds.low.head<2>()), to = grid.cell_at(bounds.high.head<2>());
  int open = 0, reached = 0;
  if (is_rectangle(room, bounds)) {
    const auto column_inside = [&](int x) {
      const double at = grid.center({x, from.y}).x();
      return at > bounds.low.x() && at < bounds.high.x();
    };
    const auto row_inside = [&](int y) {
      const double at = grid.center({from.x, y}).y();
      return at > bounds.low.y() && at < bounds.high.y();
    };
    int left = std::max(0, from.x), right = std::min(grid.width() - 1, to.x);
    int first = std::max(0, from.y), last = std::min(grid.height() - 1, to.y);
    while (left <= right && !column_inside(left)) ++left;
    while (left <= right && !column_inside(right)) --right;
    while (first <= last && !row_inside(first)) ++first;
    while (first <= last && !row_inside(last)) --last;
    bool all = true, some = false;  // as nearly always: all that is free is reached
    for (int y = first; y <= last && all; ++y) {
      all = walk.reached.covers(grid.free_cells(), y, left, right);
      some = some || walk.reached.count(y, left, right) > 0;
    }
    if (all && some) return true;
    for (int y = first; y <= last; ++y) {
      open += grid.free_cells().count(y, left, right);
      reached += walk.reached.count(y, left, right);
    }
  } else {
    for (int y = from.y; y <= to.y; ++y) {
      for (int x = from.x; x <= to.x; ++x) {
        if (!grid.free({x, y}) || !contains(room.polygon, grid.center({x, y}))) continue;
        ++open;
        if (walk.reached.has(x, y)) ++reached;
      }
    }
  }
  return reached > 0 && 2 * reached >= open;
}

}  // namespace

Walk walk_in(const Scene& scene, const Profile& profile) {
  NavigationGrid grid(scene, profile);
  CellSet reached = grid.reached_from(grid.cell_at(scene.agent.position));
  return {std::move(grid), std::move(reached), {}};
}

bool stand_at_entrance(Scene& scene, const NavigationGrid& grid) {
  const auto entrance = entrance_of(scene.rooms);
  if (!entrance) return false;
  const auto cell = grid.nearest_free(entrance->at + kInsideTheDoor_m * entrance->inward);
  if (!cell || !contains(scene.rooms.front().polygon, grid.center(*cell))) return false;
  scene.agent = {};
  scene.agent.position = grid.center(*cell);
  scene.agent.yaw = std::atan2(entrance->inward.y(), entrance->inward.x());
  return true;
}

std::optional<std::string> unreached_room(const Scene& scene, const Walk& walk) {
  for (const Room& room : scene.rooms) {
    if (!is_reached(scene, room, walk)) return room.id;
  }
  return std::nullopt;
}

std::vector<std::string> unreached_rooms(const Scene& scene, const Walk& walk) {
  std::vector<std::string> ids;
  for (const Room& room : scene.rooms) {
    if (!is_reached(scene, room, walk)) ids.push_back(room.id);
  }
  return ids;
}

std::vector<std::size_t> unreached_furniture(const Scene& scene, const PhysicsWorld& world, const Profile& profile,
                                             const Walk& walk) {
  std::vector<std::size_t> unreached;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (scene.nodes[i].movable || reached_from_the_front(scene, world, profile, walk, i)) continue;
    if (!standing_place(scene, world, walk.grid, walk.reached, profile, i)) unreached.push_back(i);
  }
  return unreached;
}

}  // namespace unietp
