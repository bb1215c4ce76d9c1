#include "simulation/outline.h"

#include <algorithm>
#include <cmath>

namespace unietp {
namespace {

/// The camera's axes in a solid's frame.
struct OwnCamera {
  Vec3 ahead, right, down;             // as directions
  Vec3 depth_of, across_of, along_of;  // as linear forms: depth, and meters to the right and down
  const Camera& camera;

  OwnCamera(const RayTarget& target, const Camera& eye)
      : ahead(target.to_own * eye.ahead),
        right(target.to_own * eye.right),
        down(target.to_own * eye.down),
        depth_of(target.forms * eye.ahead),
        across_of(target.forms * eye.right),
        along_of(target.forms * eye.down),
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

/// The range of an image coordinate, in pixels from the middle of the image.
struct Range {
  double low = kNever, high = -kNever;
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void add(const Range& other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
};

/// What tangent planes through the camera bound of a ball (`whole`) or of a level disc around a point: the roots of
/// (n . way)^2 = (radius |n|)^2, where n is the normal of the plane of an image coordinate and |n| that of its level
/// part for a disc.
Range tangents(const OwnCamera& own, const Vec3& side_of, const Vec3& way, double radius, bool whole) {
  const Vec3 flat(1, 1, whole ? 1 : 0);
  const Vec3 u = own.camera.focal * side_of.cwiseProduct(flat), d = own.depth_of.cwiseProduct(flat);
  const double aside = own.camera.focal * side_of.dot(way), deep = own.depth_of.dot(way), square = radius * radius;
  const double a = square * d.squaredNorm() - deep * deep, b = aside * deep - square * u.dot(d);
  const double c = square * u.squaredNorm() - aside * aside;
  if (!(a < 0)) return {-kNever, kNever};  // reaches beside the camera
  const double root = std::sqrt(std::max(0.0, b * b - a * c));
  return {(-b + root) / a, (-b - root) / a};
}

/// A round solid's range of an image coordinate.
Range round_range(const Outline& outline, const OwnCamera& own, const Vec3& side_of) {
  const RayTarget& target = outline.target;
  const double radius = target.half.x();
  if (target.kind == SolidKind::Sphere) return tangents(own, side_of, -outline.from, radius, true);
  Range range;
  for (const double end : {-1.0, 1.0}) {
    const double wide = end < 0 ? target.low.x() : target.high.x();
    range.add(tangents(own, side_of, Vec3(0, 0, end * target.half.z()) - outline.from, wide * radius, false));
  }
  return range;
}

bool has_corners(SolidKind kind) {
  return kind == SolidKind::Box || kind == SolidKind::Wedge || kind == SolidKind::Crate;
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
    const RayTarget& target = outline.target;
    const Vec2& wide = (i & 4) ? target.high : target.low;
    const Vec3 side((i & 1) ? wide.x() : -wide.x(), (i & 2) ? wide.y() : -wide.y(), (i & 4) ? 1 : -1);
    const Vec3 way = side.cwiseProduct(target.half) - outline.from;
    const double depth = way.dot(own.depth_of);
    outline.nearest = std::min(outline.nearest, depth);
    outline.farthest = std::max(outline.farthest, depth);
    if (depth < kNear_m) continue;
    const double x = camera.width / 2.0 + camera.focal * way.dot(own.across_of) / depth;
    const double y = camera.height / 2.0 + camera.focal * way.dot(own.along_of) / depth;
    if (x < left) left = x, leftmost = {x, y};
    if (y < top) top = y, topmost = {x, y};
    if (x > right) right = x, rightmost = {x, y};
    if (y > bottom) bottom = y, lowest = {x, y};
  }
  outline.cover = {0, 0, camera.width - 1, camera.height - 1};
  if (outline.nearest < kNear_m) return;  // it reaches behind the camera
  if (!has_corners(outline.target.kind)) {
    const double across = camera.width / 2.0, along = camera.height / 2.0;
    const Range x = round_range(outline, own, own.across_of), y = round_range(outline, own, own.along_of);
    left = std::max(left, across + x.low), right = std::min(right, across + x.high);
    top = std::max(top, along + y.low), bottom = std::min(bottom, along + y.high);
    leftmost.x() = left, rightmost.x() = right, topmost.y() = top, lowest.y() = bottom;
    leftmost.y() = rightmost.y() = (top + bottom) / 2;
    topmost.x() = lowest.x() = (left + right) / 2;
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
  outline.round = solid.kind != SolidKind::Box;
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
