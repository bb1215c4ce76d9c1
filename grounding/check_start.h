#pragma once

#include <optional>
#include <set>
#include <string>

#include "akb/knowledge.h"
#include "generator/specification.h"
#include "grounding/failure.h"
#include "grounding/grown_scene.h"
#include "scene/scene.h"
#include "simulation/profile.h"

namespace unietp {

/// What a start may have to meet besides.
struct StartGates {
  bool pictured = false;  // what the goal needs shows clearly in a picture from somewhere (check_goal)
  bool natural = false;   // as people speak of it (check_references, check_seeming, nearness_on_foot)
};

/// Checks a start using only physics, sharing nothing with the code that made it but the home that it grew out of:
/// what differs from the home is found by comparing the two, put into a fresh copy of the home's bodies, and what can
/// have changed with it is read anew. All start constraints hold; the goal is false and so is each part that the agent
/// has to bring about; no forall or count is about nothing; a referring constraint picks out something (and, where it
/// is there to tell things apart, excludes something of the same category); what the goal and its constraints name can
/// be reached; what was touched stays where it is (5 mm); the goal passes its geometric gates (check_goal); every room
/// can be walked to. The first failure, or nullopt when the start is sound. The start's edges must be those that are
/// read. `grown`: the start as read_grown gives it.
std::optional<GroundingFailure> check_start(const Specification& specification, const Home& home, const Scene& start,
                                            const GrownScene& grown, const std::set<std::string>& touched,
                                            const Knowledge& knowledge, const Profile& profile,
                                            const StartGates& gates = {});

}  // namespace unietp
