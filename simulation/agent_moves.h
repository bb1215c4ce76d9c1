#pragma once

#include <optional>

#include "scene/action.h"
#include "scene/scene.h"
#include "simulation/navigation.h"
#include "simulation/profile.h"

namespace unietp {

/// A step of the profile's length along the body's axes, a turn or a tilt of its angles; each part is -1, 0 or 1.
struct BodyMove {
  int ahead = 0, left = 0;  // steps
  int turn_left = 0;
  int tilt_down = 0;
};
/// nullopt for other actions.
std::optional<BodyMove> move_of(ActionType type);

/// The agent after a move in a straight line; nullopt when the floor is not free or the camera is at its limit.
std::optional<Agent> moved(const Agent& agent, const BodyMove& move, const NavigationGrid& grid,
                           const Profile& profile);
/// The agent turned, and its camera tilted, toward a point in W.
Agent facing(Agent agent, const Vec3& point, const Profile& profile);

}  // namespace unietp
