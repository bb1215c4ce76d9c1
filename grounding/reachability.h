#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "simulation/physics.h"
#include "simulation/profile.h"
#include "simulation/walk.h"

namespace unietp {

/// Where the agent can walk in a scene, from where it stands.
Walk walk_in(const Scene& scene, const Profile& profile);

/// Puts the agent inside the entrance (entrance_of) of a generated home, its back to the front door. False when it has
/// no entrance or the scene has no free cell in the room there.
bool stand_at_entrance(Scene& scene, const NavigationGrid& grid);

/// Id of the first room of which the agent cannot walk to most of the free floor, or nullopt. Rooms whose floor is full
/// count as not reached. `walk`: of the scene.
std::optional<std::string> unreached_room(const Scene& scene, const Walk& walk);
/// All of them, in the order of the rooms.
std::vector<std::string> unreached_rooms(const Scene& scene, const Walk& walk);

/// The pieces of furniture without a place to stand from which they are in reach and sight, by position in nodes.
std::vector<std::size_t> unreached_furniture(const Scene& scene, const PhysicsWorld& world, const Profile& profile,
                                             const Walk& walk);

}  // namespace unietp
