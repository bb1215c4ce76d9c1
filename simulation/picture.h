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

/// Which node each pixel shows, rows from the top; -1 for walls, floor, ceiling and openings.
struct Segmentation {
  /// A node that a pixel shows through glass that lies before it.
  struct Through {
    std::size_t pixel = 0;
    std::int32_t node = -1;
    auto operator<=>(const Through&) const = default;
  };
  int width = 0, height = 0;
  std::vector<std::int32_t> node;  // the nearest
  std::vector<Through> through;    // by pixel, the nearest first; one may come again
};

/// One ray through the middle of every pixel, through all glass on its way, without a limit of sight. `rays` is scratch
/// space.
Segmentation segmentation_of(const Scene& scene, const Profile& profile, Rays& rays);

/// What the agent sees: every object in its colour, or that of its material, lit from above with short shadows, with
/// dark edges. Rays through every fourth pixel, more where four of them do not agree on a face. Deterministic.
Picture picture_of(const Scene& scene, const Profile& profile, Rays& rays);
/// The same of a scene whose edges are not kept.
Picture picture_of(const ViewedScene& viewed, const Profile& profile, Rays& rays);
/// The node that one pixel shows, as segmentation_of finds it; nullopt for none and for pixels outside of the image.
std::optional<std::size_t> node_at(const ViewedScene& viewed, const Profile& profile, int x, int y, Rays& rays);

/// Draws a line of one pixel around a box [x0, y0, x1, y1], both ends included, as World::visible gives them.
void draw_box(Picture& picture, const std::array<int, 4>& box, const std::array<std::uint8_t, 3>& colour);

}  // namespace unietp
