#include "simulation/agent_moves.h"
#include "simulation/world_state.h"

// Actions of the body: steps, turns, tilts of the camera.
namespace unietp {

ActionResult move_body(WorldState& state, ActionType type) {
  const BodyMove move = move_of(type).value_or(BodyMove{});
  const auto after = moved(state.agent(), move, state.grid(), *state.profile);
  if (!after && move.tilt_down != 0)
    return failed(move.tilt_down > 0 ? FailureCause::CameraAtLowest : FailureCause::CameraAtHighest);
  if (!after) return failed(FailureCause::BodyBlocked);
  state.edit_agent() = *after;
  if (move.tilt_down == 0) state.carry_along();
  return succeeded();
}

ActionResult reset_head(WorldState& state) {
  state.edit_agent().pitch = 0;
  return succeeded();
}

}  // namespace unietp
