#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "simulation/mode_episode.h"

namespace unietp {

/// Where the agent may stand to see something.
enum class Viewpoint {
  Anywhere,
  InReach,  // where the arm reaches the object and nothing hides it from the hand
  Here,     // only turning and tilting the camera
};

/// The cheapest steps known after which an object shows clearly in the picture, or in M2, where it is named by id, is
/// near enough to be told of and shows at all; none when it is so already. From where the agent stands, or from a room,
/// piece of furniture or object that the mode lets it go to in one step, it turns, tilts the camera and walks a little.
/// It may know where to look: the search is made with the scene at hand, what is done of it an agent could have done.
/// nullopt when nothing within the search shows the object. `looks_left`: how many poses it may look from, counted
/// down; nullptr: as many as the search has. Deterministic.
std::optional<std::vector<Action>> way_to_see(const ModeEpisode& episode, const std::string& id,
                                              Viewpoint standing = Viewpoint::Anywhere,
                                              std::size_t* looks_left = nullptr);

/// Furniture to look from when the object itself cannot be found: what it lies on or in first, then what is nearest.
std::vector<std::string> lookouts_for(const World& world, const std::string& id);
/// All that is near an object and not in the hand, the nearest first: what is gone to leads to places of its own.
std::vector<std::string> things_near(const World& world, const std::string& id);

}  // namespace unietp
