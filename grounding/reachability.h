#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "simulation/navigation.h"
#include "simulation/physics.h"
#include "simulation/profile.h"

namespace unietp {

// What is asked of a grid of the scene's free floor can be given the grid, when it is at hand; it must be that of the
// scene and the profile.

/// Puts the agent on the free cell nearest to the middle of the first room, facing along an axis towards the room's
/// longer side. False when the scene has no free cell in that room.
bool stand_in_first_room(Scene& scene, const NavigationGrid& grid);

/// Id of the first room of which the agent cannot walk to most of the free floor, or nullopt. Rooms whose floor is full
/// count as not reached.
std::optional<std::string> unreached_room(const Scene& scene, const NavigationGrid& grid);
std::optional<std::string> unreached_room(const Scene& scene, const Profile& profile);

/// The pieces of furniture without a place to stand from which they are in reach and sight, by position in nodes.
std::vector<std::size_t> unreached_furniture(const Scene& scene, const PhysicsWorld& world, const Profile& profile,
                                             const NavigationGrid& grid);

}  // namespace unietp
