#include <algorithm>
#include <limits>

#include "simulation/world_state.h"

namespace unietp {

std::optional<Vec2> place_in_room(const WorldState& state, const Room& room) {
  Vec2 middle = Vec2::Zero();
  for (const Vec2& corner : room.polygon) middle += corner / static_cast<double>(room.polygon.size());
  const NavigationGrid& grid = state.grid();
  const auto& walk = state.walk();
  std::optional<Vec2> best;
  double best_distance = std::numeric_limits<double>::infinity();
  Vec2 low = middle, high = middle;
  for (const Vec2& corner : room.polygon) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const auto from = grid.cell_at(low), to = grid.cell_at(high);
  const int left = std::max(0, from.x), right = std::min(grid.width() - 1, to.x);
  if (left > right) return std::nullopt;
  const int center = std::clamp(grid.cell_at(middle).x, left, right);
  // Each row is searched from the middle outwards until no cell can be nearer. Ties by row, then column.
  const auto look_along = [&](int y, int x, int step) {
    for (; x >= left && x <= right; x += step) {
      const Vec2 at = grid.center({x, y});
      const double distance = (at - middle).squaredNorm();
      if (distance >= best_distance) return;
      if (!walk.has(x, y) || !contains(room.polygon, at)) continue;
      best_distance = distance;
      best = at;
      return;
    }
  };
  for (int y = std::max(0, from.y); y <= std::min(grid.height() - 1, to.y); ++y) {
    look_along(y, center - 1, -1);
    look_along(y, center, 1);
  }
  return best;
}

ActionResult go_to(WorldState& state, const std::string& id) {
  if (const Room* room = find_room(state.scene(), id)) {
    const auto place = place_in_room(state, *room);
    if (!place) return failed(FailureCause::RoomUnreachable, reference_to(*room));
    Agent& agent = state.edit_agent();
    agent.position = *place;
    agent.pitch = 0;
    state.carry_along();
    return succeeded();
  }
  const auto node = state.index_of(id);
  if (!node) return failed(FailureCause::NoSuchObjectOrRoom, unknown_name(id));
  if (state.held(id)) return failed(FailureCause::InHand, state.reference(*node));
  // For an object in a closed container the agent goes to the container.
  const std::size_t target = state.closed_around(*node).value_or(*node);
  const auto place = state.standing_place(target);
  if (!place) return failed(FailureCause::NoPlaceToStand, state.reference(*node));
  state.edit_agent().position = *place;
  look_at(state, state.node(target).pose.position);
  state.carry_along();
  return succeeded();
}

ActionResult turn_to(WorldState& state, std::size_t node) {
  if (state.held(state.node(node).id)) return failed(FailureCause::InHand, state.reference(node));
  if (state.closed_around(node) ||
      !sees(state.scene(), state.physics(), *state.profile, state.agent().position, node)) {
    return failed(FailureCause::OutOfSight, state.reference(node));
  }
  look_at(state, state.node(node).pose.position);
  state.carry_along();
  return succeeded();
}

}  // namespace unietp
