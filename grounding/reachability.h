#pragma once

#include <optional>
#include <string>

#include "scene/scene.h"
#include "simulation/physics.h"
#include "simulation/profile.h"

namespace unietp {

/// Puts the agent on the free cell nearest to the middle of the first room, facing along an axis towards the room's
/// longer side. False when the scene has no free cell in that room.
bool stand_in_first_room(Scene& scene, const Profile& profile);

/// Id of the first room of which the agent cannot walk to most of the free floor, or nullopt. Rooms whose floor is full
/// count as not reached.
std::optional<std::string> unreached_room(const Scene& scene, const Profile& profile);

/// Id of the first piece of furniture without a place to stand from which it is in reach and sight, or nullopt.
std::optional<std::string> unreached_furniture(const Scene& scene, const PhysicsWorld& world, const Profile& profile);

}  // namespace unietp
