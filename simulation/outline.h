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

/// The range of the centers of a rectangle's pixels: from `middle - half` to `middle + half`.
struct PartOfImage {
  explicit PartOfImage(const PixelBox& box)
      : middle((box[0] + box[2] + 1) / 2.0, (box[1] + box[3] + 1) / 2.0),
        half((box[2] - box[0]) / 2.0, (box[3] - box[1]) / 2.0) {}
  Vec2 middle, half;
};

/// A function a x + b y + c over the image, in pixels.
struct OverImage {
  double a = 0, b = 0, c = 0;
};

/// N such functions, N even for vectorization. Those that are not set are infinite.
template <int N>
struct ManyOverImage {
  using Values = Eigen::Array<double, N, 1>;
  Values a = Values::Zero(), b = Values::Zero(), c = Values::Constant(kNever);

  void set(std::size_t i, const OverImage& one) {  // the i-th function, from 0
    const auto at = static_cast<Eigen::Index>(i);
    a[at] = one.a, b[at] = one.b, c[at] = one.c;
  }
  /// The minimum of their minima and the minimum of their maxima over a part of the image.
  [[gnu::always_inline]] std::pair<double, double> least_in(const PartOfImage& part) const {
    const Values middle = a * part.middle.x() + b * part.middle.y() + c;
    const Values reach = a.abs() * part.half.x() + b.abs() * part.half.y();
    return {(middle - reach).minCoeff(), (middle + reach).minCoeff()};
  }
};

/// The projection of a box, or of the box around another solid, onto an image. A box is convex, so it is visible
/// exactly where none of its `sides` is negative, and there 1 / depth is the minimum of its `faces`.
struct Outline {
  Outline(const Solid& solid, const Camera& camera)
      : owner(solid.owner), clear(solid.clear), target(solid), from(target.to_own * (camera.at - target.center)) {}

  PixelBox cover{};                  // bounds of the pixels that it may cover
  double nearest = 0, farthest = 0;  // depth, meters
  std::int32_t owner;
  bool clear;          // hides nothing
  bool round = false;  // no box: sides and faces are those of the box around it
  std::uint8_t side_count = 0, face_count = 0;
  ManyOverImage<4> faces;
  ManyOverImage<6> sides;
  std::array<Vec2, 4> extremes{};  // pixels of its leftmost, highest, rightmost and lowest corners
  RayTarget target;
  Vec3 from;  // the camera in the solid's frame

  /// Depth at which the ray through a pixel's middle enters it, bit for bit as Rays finds it; kNever when it misses.
  double depth_at(const Camera& camera, int x, int y) const;
};

/// nullopt for a solid outside of the image or around the camera.
std::optional<Outline> outline_of(const Solid& solid, const Camera& camera);

}  // namespace unietp
