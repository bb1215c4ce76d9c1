#pragma once

#include <cstdint>
#include <vector>

#include "akb/knowledge.h"
#include "simulation/picture.h"

namespace unietp {

/// How a portrait is taken.
struct PortraitOptions {
  int pixels = 200;       // width and height of the picture
  double turn_rad = 0.6;  // of the camera around the object, from its front
  double down_rad = 0.45;
  bool on_table = true;  // otherwise it stands on the floor of a room
};

/// What a portrait is a picture of: the object, which is the last node of the scene.
struct Portrait {
  Scene scene;
  Profile camera;
};
Portrait portrait_scene(const Node& object, const Profile& profile, const PortraitOptions& options);

/// An object alone, as large as it fits, as the agent's camera shows it. Its place is not used. Deterministic.
Picture portrait_of(const Node& object, const Profile& profile, const PortraitOptions& options);

/// An object of a category in its first states, with a color and a material that it usually has; `seed` tells one from
/// another.
Node object_of(const Knowledge& knowledge, const Category& category, std::uint32_t seed);

/// Pictures of one size beside and below each other, white where there is none. At least one picture.
Picture sheet_of(const std::vector<Picture>& pictures, int columns);

}  // namespace unietp
