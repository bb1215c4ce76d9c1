#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/result.h"
#include "scene/scene.h"
#include "simulation/profile.h"

namespace unietp {

/// A room as one sees it from inside.
struct RoomView {
  std::string room;  // id
  std::string png;
};

/// A home as pictures.
struct ShownHome {
  std::string id;
  Simulator simulator = Simulator::Ai2thor;
  std::size_t rooms = 0, objects = 0;
  std::string svg;              // from above, without line ends
  std::vector<RoomView> views;  // in the order of the rooms
};

/// A home from above, and from inside at most `views` of its rooms, the largest of each type first. The camera stands
/// where the agent can walk to, of the ends of the room that from which it sees the most objects, and looks to the
/// room's middle. `width`: of the pictures in pixels, which are three quarters as high. Deterministic.
/// Errors: Io when libpng refuses a picture.
Result<ShownHome> shown_home(const Scene& home, const Profile& profile, std::size_t views, int width);

/// One self-contained page with all homes, by simulator in the order of kSimulators.
std::string home_page(const std::vector<ShownHome>& homes);

}  // namespace unietp
