#include "simulation/agent_moves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace unietp {
namespace {

constexpr double kLookAhead_m = 0.05;  // spacing of the points at which a step is checked

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// Into (-pi, pi], so that full turns do not add up.
double wrapped(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

}  // namespace

std::optional<BodyMove> move_of(ActionType type) {
  switch (type) {
    case ActionType::MoveForward:
      return BodyMove{.ahead = 1};
    case ActionType::MoveBackward:
      return BodyMove{.ahead = -1};
    case ActionType::MoveLeft:
      return BodyMove{.left = 1};
    case ActionType::MoveRight:
      return BodyMove{.left = -1};
    case ActionType::TurnLeft:
      return BodyMove{.turn_left = 1};
    case ActionType::TurnRight:
      return BodyMove{.turn_left = -1};
    case ActionType::LookUp:
      return BodyMove{.tilt_down = -1};
    case ActionType::LookDown:
      return BodyMove{.tilt_down = 1};
    default:
      return std::nullopt;
  }
}

std::optional<Agent> moved(const Agent& agent, const BodyMove& move, const NavigationGrid& grid,
                           const Profile& profile) {
  Agent after = agent;
  if (move.ahead != 0 || move.left != 0) {
    const Vec2 forward(std::cos(agent.yaw), std::sin(agent.yaw)), side(-forward.y(), forward.x());
    const Vec2 way = profile.step_m * (move.ahead * forward + move.left * side);
    const int points = std::max(1, static_cast<int>(std::ceil(way.norm() / kLookAhead_m)));
    for (int i = 1; i <= points; ++i) {
      const Vec2 at = agent.position + way * (static_cast<double>(i) / points);
      if (!grid.free(grid.cell_at(at))) return std::nullopt;
    }
    after.position += way;
  }
  if (move.turn_left != 0) after.yaw = wrapped(agent.yaw + move.turn_left * radians(profile.turn_deg));
  if (move.tilt_down != 0) {
    constexpr double kSlack = 1e-9;
    after.pitch = agent.pitch + move.tilt_down * radians(profile.look_deg);
    const bool too_far =
        after.pitch > radians(profile.most_down_deg) + kSlack || after.pitch < -radians(profile.most_up_deg) - kSlack;
    if (too_far) return std::nullopt;
  }
  return after;
}

Agent facing(Agent agent, const Vec3& point, const Profile& profile) {
  const Vec2 way = point.head<2>() - agent.position;
  if (way.norm() > 1e-9) agent.yaw = std::atan2(way.y(), way.x());
  agent.pitch = std::atan2(profile.camera_height_m - point.z(), way.norm());
  return agent;
}

}  // namespace unietp
