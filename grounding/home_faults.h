#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "akb/knowledge.h"
#include "scene/scene.h"
#include "simulation/profile.h"

namespace unietp {

/// What can be wrong with a home as it is.
enum class HomeFault : std::uint8_t {
  Blocked,          // a door, lid or drawer of furniture meets something fixed on its way; `other`: what
  CutOff,           // a room of which the agent cannot walk to most of the free floor; `object`: the room
  Floating,         // furniture that touches nothing within 5 cm: no floor, wall, ceiling or other furniture
  Frozen,           // a person could pick it up, but it is fixed in place
  OutOfReach,       // furniture without a place to stand from which it is in reach and sight
  OutsideRooms,     // its middle is more than half a meter from every room
  Overlap,          // two objects are in one another by more than 2 mm; `by_m`: the deepest of their solids
  Restless,         // a movable object falls, slides or rolls by `by_m`, more than 5 mm, in two seconds of physics
  Sunk,             // below the floor by more than 2 mm
  UnknownCategory,  // the knowledge base has none of that name: no task can be about it
};
std::string_view name_of(HomeFault fault);  // "blocked"
/// What that means, for people.
std::string_view meaning_of(HomeFault fault);

/// One fault of one object or room.
struct HomeFinding {
  HomeFault fault = HomeFault::Blocked;
  std::string object, category;  // ids of the scene; of a room its type
  std::string other;             // id of the other object, "wall" or "floor"; "" for none
  double by_m = 0;               // 0 where there is no distance
  bool operator==(const HomeFinding&) const = default;
};

/// Stage: a scene → what is wrong with it, in the order of the faults, then of rooms or nodes. Nothing is changed. The
/// time grows with the objects: two seconds of physics of all movable ones, twice (less in a heap of thousands:
/// limits::kMostWork), and a place to stand for each piece of furniture. Deterministic.
std::vector<HomeFinding> faults_of(const Scene& scene, const Knowledge& knowledge, const Profile& profile);

}  // namespace unietp
