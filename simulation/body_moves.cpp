#include "simulation/agent_moves.h"
#include "simulation/world_state.h"

// What the agent does with its body alone: steps, turns, tilts of the camera.
namespace unietp {

Outcome move_body(WorldState& state, ActionType type) {
  const BodyMove move = move_of(type).value_or(BodyMove{});
  const auto after = moved(state.agent(), move, state.grid(), *state.profile);
  if (!after && move.tilt_down != 0)
    return failed(Failure::Blocked, std::string("You cannot look further ") + (move.tilt_down > 0 ? "down." : "up."));
  if (!after) return failed(Failure::Blocked, "Something is in the way of your body.");
  state.edit_agent() = *after;
  if (move.tilt_down == 0) state.carry_along();
  return succeeded();
}

Outcome reset_head(WorldState& state) {
  state.edit_agent().pitch = 0;
  return succeeded();
}

}  // namespace unietp
