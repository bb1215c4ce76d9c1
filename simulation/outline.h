#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "scene/pixel_box.h"
#include "simulation/camera.h"
#include "simulation/ray_entry.h"

namespace unietp {

/// The middles of a part's pixels: from `middle - half` to `middle + half`.
struct PartOfImage {
  explicit PartOfImage(const PixelBox& box)
      : middle((box[0] + box[2] + 1) / 2.0, (box[1] + box[3] + 1) / 2.0),
        half((box[2] - box[0]) / 2.0, (box[3] - box[1]) / 2.0) {}
  Vec2 middle, half;
};

/// A function a x + b y + c over the image, in pixels.
struct OverImage {
  double a = 0, b = 0, c = 0;
  /// Its least and its greatest value over a part.
  std::pair<double, double> range(const PartOfImage& part) const {
    const double value = a * part.middle.x() + b * part.middle.y() + c;
    const double reach = std::abs(a) * part.half.x() + std::abs(b) * part.half.y();
    return {value - reach, value + reach};
  }
};

/// How a solid, or for a round one the box around it, lies in an image. A box is convex, so it shows exactly where none
/// of its `sides` is negative, and there 1 / depth is the least of its `faces`.
struct Outline {
  Outline(const Solid& solid, const Camera& camera)
      : owner(solid.owner), target(solid), from(target.to_own * (camera.at - target.centre)) {}

  PixelBox cover{};                  // all pixels whose middles it may show in
  double nearest = 0, farthest = 0;  // depth, metres
  std::int32_t owner;
  bool round = false;
  std::uint8_t side_count = 0, face_count = 0;
  std::array<OverImage, 3> faces;
  std::array<OverImage, 6> sides;
  std::array<Vec2, 4> extremes{};  // where its corners farthest left, up, right and down are seen
  RayTarget target;
  Vec3 from;  // the eye in the solid's frame

  /// Depth at which the ray through a pixel's middle enters it, bit for bit as Rays finds it; kNever when it misses.
  double depth_at(const Camera& camera, int x, int y) const;
};

/// nullopt for a solid that the image does not show, or from whose inside it is seen.
std::optional<Outline> outline_of(const Solid& solid, const Camera& camera);

}  // namespace unietp
