#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "scene/scene.h"
#include "simulation/profile.h"
#include "simulation/rays.h"
#include "simulation/view.h"

namespace unietp {

/// Rows from the top, three bytes a pixel: red, green, blue.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

/// What the agent sees: every object in its color, or that of its material, lit from above with short shadows, with
/// dark edges. Each pixel shows what the ray through its middle meets, as boxes, segmentation and channels have it, but
/// that what the agent holds is in the lower corners. Deterministic.
Picture picture_of(const Scene& scene, const Profile& profile, Rays& rays);
/// The same of a scene whose edges are not kept.
Picture picture_of(const ViewedScene& viewed, const Profile& profile, Rays& rays);
/// What another camera sees of it; what the agent holds is in the lower corners, as if it were its eye.
Picture picture_of(const ViewedScene& viewed, const Camera& camera, Rays& rays);
/// The node that one pixel shows, as segmentation_of finds it; nullopt for none and for pixels outside of the image.
std::optional<std::size_t> node_at(const ViewedScene& viewed, const Profile& profile, int x, int y, Rays& rays);

/// Draws a line of one pixel around a box [x0, y0, x1, y1], both ends included, as World::visible gives them.
void draw_box(Picture& picture, const std::array<int, 4>& box, const std::array<std::uint8_t, 3>& color);

}  // namespace unietp
