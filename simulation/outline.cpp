#include "simulation/outline.h"

#include <algorithm>
#include <cmath>

namespace unietp {
namespace {

/// The camera's axes in a solid's frame.
struct OwnCamera {
  Vec3 ahead, right, down;
  const Camera& camera;

  OwnCamera(const RayTarget& target, const Camera& eye)
      : ahead(target.to_own * eye.ahead),
        right(target.to_own * eye.right),
        down(target.to_own * eye.down),
        camera(eye) {}

  /// normal . (direction of the ray through a point of the image)
  OverImage along(const Vec3& normal) const {
    OverImage line{normal.dot(right) / camera.focal, normal.dot(down) / camera.focal, normal.dot(ahead)};
    line.c -= line.a * camera.width / 2.0 + line.b * camera.height / 2.0;
    return line;
  }
};

/// For each axis of a box the face on whose side the camera is: 1 or -1, or 0 when it is between both.
std::array<int, 3> faces_seen(const Vec3& from, const Vec3& half) {
  std::array<int, 3> seen{};
  for (int i = 0; i < 3; ++i) seen[static_cast<std::size_t>(i)] = from[i] > half[i] ? 1 : from[i] < -half[i] ? -1 : 0;
  return seen;
}

void add_faces(Outline& outline, const OwnCamera& own, const std::array<int, 3>& seen) {
  for (int i = 0; i < 3; ++i) {
    const int side = seen[static_cast<std::size_t>(i)];
    if (side == 0) continue;
    Vec3 normal = Vec3::Zero();
    normal[i] = 1 / (side * outline.target.half[i] - outline.from[i]);
    outline.faces.set(outline.face_count++, own.along(normal));
  }
}

/// Planes through the camera and each edge between a visible and a hidden face.
void add_sides(Outline& outline, const OwnCamera& own, const std::array<int, 3>& seen) {
  const Vec3 &half = outline.target.half, &from = outline.from;
  for (int i = 0; i < 3; ++i) {
    for (int j = i + 1; j < 3; ++j) {
      for (const int s : {-1, 1}) {
        for (const int t : {-1, 1}) {
          if ((seen[static_cast<std::size_t>(i)] == s) == (seen[static_cast<std::size_t>(j)] == t)) continue;
          Vec3 normal = Vec3::Zero();
          normal[i] = t * half[j] - from[j];
          normal[j] = from[i] - s * half[i];
          outline.sides.set(outline.side_count++, own.along(normal.dot(from) > 0 ? Vec3(-normal) : normal));
        }
      }
    }
  }
}

/// The point of a sphere or an upright cylinder, in its own frame, that lies farthest along a direction.
Vec3 farthest_along(const RayTarget& target, const Vec3& direction) {
  const double radius = target.half.x();
  if (target.kind == Part::Kind::Sphere) return radius * direction.normalized();
  const double level = direction.head<2>().norm();
  const Vec2 aside = level > 0 ? Vec2(radius / level * direction.head<2>()) : Vec2(Vec2::Zero());
  return {aside.x(), aside.y(), direction.z() < 0 ? -target.half.z() : target.half.z()};
}

/// The image coordinate of the tangent plane of a sphere or cylinder along one axis, by bisection between that of the
/// inside and that of its box. `side` is 1 for the right or lower end.
double touched_at(Outline& outline, const OwnCamera& own, bool down, int side, double inner, double outer) {
  constexpr int kHalvings = 12;  // to a fraction of a pixel; rounds outwards
  const Vec3& axis = down ? own.down : own.right;
  Vec3 touching = Vec3::Zero();
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (inner + outer) / 2;
    const Vec3 normal = side * (own.camera.focal * axis - middle * own.ahead);
    const Vec3 point = farthest_along(outline.target, normal);
    if (normal.dot(point - outline.from) >= 0) {
      inner = middle;
      touching = point;
    } else {
      outer = middle;
    }
  }
  const Vec3 way = touching - outline.from;
  const double pixels = own.camera.focal / way.dot(own.ahead);
  outline.extremes[static_cast<std::size_t>((down ? 1 : 0) + (side > 0 ? 2 : 0))] =
      Vec2(own.camera.width / 2.0 + pixels * way.dot(own.right), own.camera.height / 2.0 + pixels * way.dot(own.down));
  return outer;
}

/// Sets the depth range and the pixels that it may cover, from its corners.
void bound(Outline& outline, const OwnCamera& own) {
  constexpr double kNear_m = 0.02, kSlack_pixels = 1e-6;
  const Camera& camera = own.camera;
  outline.nearest = kNever;
  outline.farthest = -kNever;
  double left = kNever, top = kNever, right = -kNever, bottom = -kNever;
  auto& [leftmost, topmost, rightmost, lowest] = outline.extremes;
  for (int i = 0; i < 8; ++i) {
    const Vec3 side((i & 1) ? 1 : -1, (i & 2) ? 1 : -1, (i & 4) ? 1 : -1);
    const Vec3 way = side.cwiseProduct(outline.target.half) - outline.from;
    const double depth = way.dot(own.ahead);
    outline.nearest = std::min(outline.nearest, depth);
    outline.farthest = std::max(outline.farthest, depth);
    if (depth < kNear_m) continue;
    const double x = camera.width / 2.0 + camera.focal * way.dot(own.right) / depth;
    const double y = camera.height / 2.0 + camera.focal * way.dot(own.down) / depth;
    if (x < left) left = x, leftmost = {x, y};
    if (y < top) top = y, topmost = {x, y};
    if (x > right) right = x, rightmost = {x, y};
    if (y > bottom) bottom = y, lowest = {x, y};
  }
  outline.cover = {0, 0, camera.width - 1, camera.height - 1};
  if (outline.nearest < kNear_m) return;  // it reaches behind the camera
  if (outline.round) {
    const double across = camera.width / 2.0, along = camera.height / 2.0;
    const double low_x = left - across, high_x = right - across, low_y = top - along, high_y = bottom - along;
    left = across + touched_at(outline, own, false, -1, high_x, low_x);
    right = across + touched_at(outline, own, false, 1, low_x, high_x);
    top = along + touched_at(outline, own, true, -1, high_y, low_y);
    bottom = along + touched_at(outline, own, true, 1, low_y, high_y);
  }
  const auto clip = [](double value, int size) { return static_cast<int>(std::clamp(value, -1.0, size + 0.0)); };
  outline.cover = {std::max(0, clip(std::ceil(left - 0.5 - kSlack_pixels), camera.width)),
                   std::max(0, clip(std::ceil(top - 0.5 - kSlack_pixels), camera.height)),
                   std::min(camera.width - 1, clip(std::floor(right - 0.5 + kSlack_pixels), camera.width)),
                   std::min(camera.height - 1, clip(std::floor(bottom - 0.5 + kSlack_pixels), camera.height))};
}

}  // namespace

double Outline::depth_at(const Camera& camera, int x, int y) const {
  return enter(target, from, target.to_own * camera.ray(x + 0.5, y + 0.5)).along;
}

std::optional<Outline> outline_of(const Solid& solid, const Camera& camera) {
  Outline outline(solid, camera);
  outline.round = solid.kind != Part::Kind::Box;
  const OwnCamera own(outline.target, camera);
  bound(outline, own);
  const PixelBox& cover = outline.cover;
  if (outline.farthest <= 0 || cover[0] > cover[2] || cover[1] > cover[3]) return std::nullopt;
  const auto seen = faces_seen(outline.from, outline.target.half);
  if (seen == std::array{0, 0, 0}) {
    if (!outline.round) return std::nullopt;
    outline.nearest = 0;
    return outline;
  }
  add_faces(outline, own, seen);
  add_sides(outline, own, seen);
  return outline;
}

}  // namespace unietp
