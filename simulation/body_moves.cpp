#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulation/world_state.h"

// What the agent does with its body alone: steps, turns, tilts of the camera.
namespace unietp {
namespace {

constexpr double kLookAhead_m = 0.05;  // a step is checked at points this far apart

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// Into (-pi, pi], so that full turns do not add up.
double wrapped(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

}  // namespace

Outcome take_step(WorldState& state, double ahead, double left) {
  Agent& agent = state.scene.agent;
  const Vec2 forward(std::cos(agent.yaw), std::sin(agent.yaw)), side(-forward.y(), forward.x());
  const Vec2 way = state.profile->step_m * (ahead * forward + left * side);
  const int points = std::max(1, static_cast<int>(std::ceil(way.norm() / kLookAhead_m)));
  for (int i = 1; i <= points; ++i) {
    const Vec2 at = agent.position + way * (static_cast<double>(i) / points);
    if (!state.grid().free(state.grid().cell_at(at)))
      return failed(Failure::Blocked, "Something is in the way of your body.");
  }
  agent.position += way;
  state.forget_walk();
  state.carry_along();
  return succeeded();
}

Outcome turn_body(WorldState& state, double left) {
  state.scene.agent.yaw = wrapped(state.scene.agent.yaw + left * radians(state.profile->turn_deg));
  state.carry_along();
  return succeeded();
}

Outcome tilt_camera(WorldState& state, double down) {
  Agent& agent = state.scene.agent;
  const double pitch = agent.pitch + down * radians(state.profile->look_deg);
  constexpr double kSlack = 1e-9;
  if (pitch > radians(state.profile->most_down_deg) + kSlack || pitch < -radians(state.profile->most_up_deg) - kSlack)
    return failed(Failure::Blocked, std::string("You cannot look further ") + (down > 0 ? "down." : "up."));
  agent.pitch = pitch;
  return succeeded();
}

Outcome reset_head(WorldState& state) {
  state.scene.agent.pitch = 0;
  return succeeded();
}

}  // namespace unietp
