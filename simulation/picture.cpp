#include "simulation/picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulation/camera.h"
#include "simulation/paint.h"
#include "simulation/solids.h"

namespace unietp {
namespace {

constexpr double kEverywhere_m = 1000;
constexpr double kShadow_m = 0.8;  // longest shadow
const Vec3 kSun = Vec3(0.35, 0.2, 0.9).normalized();

/// What a pixel shows: a face of a solid, the floor, the ceiling or an opening.
struct Spot {
  static constexpr std::int32_t kOpen = -1, kFloor = -2, kCeiling = -3;
  std::int32_t solid = kOpen;
  double depth = std::numeric_limits<double>::infinity();
  Vec3 normal = Vec3::UnitZ();  // W
  bool same_face(const Spot& other) const { return solid == other.solid && normal == other.normal; }
};

class Painter {
 public:
  Painter(const Scene& scene, const Camera& camera, const Rays& rays)
      : scene_(scene), camera_(camera), rays_(rays), spots_(size()), known_(size(), 0), lights_(size(), -1.0F) {
    for (const Node& node : scene.nodes) paints_.push_back(paint_of(node));
  }

  Picture paint() {
    find_spots();
    Picture picture{camera_.width, camera_.height, {}};
    picture.rgb.reserve(3 * size());
    for (int y = 0; y < camera_.height; ++y) {
      for (int x = 0; x < camera_.width; ++x) {
        const Colour colour = paint_at(x, y) * light_at(x, y) * rim_at(x, y);
        for (int c = 0; c < 3; ++c)
          picture.rgb.push_back(static_cast<std::uint8_t>(std::clamp(std::round(colour[c]), 0.0, 255.0)));
      }
    }
    return picture;
  }

 private:
  std::size_t size() const {
    return static_cast<std::size_t>(camera_.width) * static_cast<std::size_t>(camera_.height);
  }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(camera_.width) + static_cast<std::size_t>(x);
  }
  Vec3 way(int x, int y) const { return camera_.ray(x + 0.5, y + 0.5); }

  Spot look(int x, int y) const {
    const Vec3 direction = way(x, y);
    const auto hit = rays_.first(camera_.at, direction, kEverywhere_m);
    return hit ? Spot{static_cast<std::int32_t>(hit->solid), hit->along, hit->normal} : shell(direction);
  }
  /// Floor and ceiling are planes behind everything else.
  Spot shell(const Vec3& direction) const {
    if (direction.z() < 0) return {Spot::kFloor, -camera_.at.z() / direction.z(), Vec3::UnitZ()};
    if (direction.z() > 0)
      return {Spot::kCeiling, (scene_.wall_height - camera_.at.z()) / direction.z(), -Vec3::UnitZ()};
    return {};
  }

  void find(int x, int y) {
    if (known_[index(x, y)]) return;
    known_[index(x, y)] = true;
    spots_[index(x, y)] = look(x, y);
  }

  /// Casts a ray through every fourth pixel and fills the squares between them.
  void find_spots() {
    constexpr int kStep = 4;
    const auto next = [](int at, int pixels) { return std::min(at + kStep, pixels - 1); };
    for (int y = 0; y < camera_.height - 1; y = next(y, camera_.height)) {
      for (int x = 0; x < camera_.width - 1; x = next(x, camera_.width))
        fill(x, y, next(x, camera_.width), next(y, camera_.height));
    }
  }

  /// A square whose four corners show the same flat face shows it everywhere; others are subdivided.
  void fill(int x0, int y0, int x1, int y1) {
    for (const auto& [x, y] : {std::pair{x0, y0}, std::pair{x1, y0}, std::pair{x0, y1}, std::pair{x1, y1}}) find(x, y);
    const Spot corner = spots_[index(x0, y0)];
    const bool even = corner.same_face(spots_[index(x1, y0)]) && corner.same_face(spots_[index(x0, y1)]) &&
                      corner.same_face(spots_[index(x1, y1)]);
    if (!even) {
      const int x = (x0 + x1) / 2, y = (y0 + y1) / 2;
      if (x > x0 || y > y0) {
        fill(x0, y0, std::max(x, x0 + 1), std::max(y, y0 + 1));
        if (x > x0) fill(x, y0, x1, std::max(y, y0 + 1));
        if (y > y0) fill(x0, y, std::max(x, x0 + 1), y1);
        if (x > x0 && y > y0) fill(x, y, x1, y1);
      }
      return;
    }
    const double away = corner.depth * way(x0, y0).dot(corner.normal);  // distance of the face's plane from the camera
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        if (known_[index(x, y)]) continue;
        known_[index(x, y)] = true;
        const Vec3 direction = way(x, y);
        spots_[index(x, y)] = corner.solid < 0 ? shell(direction)
                                               : Spot{corner.solid, away / direction.dot(corner.normal), corner.normal};
      }
    }
  }

  Colour paint_at(int x, int y) {
    const Spot& spot = spots_[index(x, y)];
    if (spot.solid == Spot::kOpen) return kOpenPaint;
    if (spot.solid == Spot::kCeiling) return kCeilingPaint;
    if (spot.solid == Spot::kFloor) {
      const Vec2 at = (camera_.at + spot.depth * way(x, y)).head<2>();
      if (room_ == nullptr || !contains(room_->polygon, at)) room_ = room_at(scene_, at);
      return floor_paint(room_, at);
    }
    const Solid& solid = rays_.solids()[static_cast<std::size_t>(spot.solid)];
    if (solid.owner < 0) return kWallPaint;
    constexpr double kDoor = 0.93;  // doors are slightly darker than the body
    return paints_[static_cast<std::size_t>(solid.owner)] * (solid.moves ? kDoor : 1);
  }

  /// Computed once for two by two pixels that show one face.
  double light_at(int x, int y) {
    const int x0 = x & ~1, y0 = y & ~1;
    const bool same = spots_[index(x, y)].same_face(spots_[index(x0, y0)]);
    float& light = lights_[same ? index(x0, y0) : index(x, y)];
    if (light < 0) light = static_cast<float>(same ? lit(x0, y0) : lit(x, y));
    return light;
  }

  /// Ambient light, light from the camera, and sunlight where it is not blocked.
  double lit(int x, int y) const {
    const Spot& spot = spots_[index(x, y)];
    if (spot.solid == Spot::kOpen) return 1;
    const Vec3 direction = way(x, y);
    const double facing = std::abs(spot.normal.dot(direction.normalized()));
    if (spot.solid == Spot::kCeiling) return 0.9 + 0.1 * facing;
    constexpr double kAround = 0.48, kEye = 0.26, kAbove = 0.28, kLift_m = 0.001;
    const double above = spot.normal.dot(kSun);
    const Vec3 at = camera_.at + spot.depth * direction + kLift_m * spot.normal;
    const bool in_sun = above > 0 && !rays_.first(at, kSun, kShadow_m);
    return kAround + kEye * facing + (in_sun ? kAbove * above : 0);
  }

  /// Darkens outlines of objects, and less so edges between faces.
  double rim_at(int x, int y) const {
    const Spot& here = spots_[index(x, y)];
    constexpr double kEnd = 0.5, kFold = 0.82;
    double rim = 1;
    for (const auto& [nx, ny] : {std::pair{x + 1, y}, std::pair{x, y + 1}}) {
      if (nx >= camera_.width || ny >= camera_.height) continue;
      const Spot& there = spots_[index(nx, ny)];
      if (owner(here) != owner(there)) {
        rim = std::min(rim, kEnd);
      } else if (here.solid >= 0 && there.solid >= 0) {
        constexpr double kStep = 0.02, kTurn = 0.8;
        const bool apart = std::abs(here.depth - there.depth) > kStep + kStep * here.depth;
        if (apart || here.normal.dot(there.normal) < kTurn) rim = std::min(rim, kFold);
      }
    }
    return rim;
  }
  /// Owner of a spot; walls, floor, ceiling and openings have numbers of their own.
  std::int32_t owner(const Spot& spot) const {
    if (spot.solid < 0) return spot.solid - 1;
    return rays_.solids()[static_cast<std::size_t>(spot.solid)].owner;
  }

  const Scene& scene_;
  const Camera& camera_;
  const Rays& rays_;
  std::vector<Colour> paints_;  // of the nodes
  std::vector<Spot> spots_;
  std::vector<std::uint8_t> known_;  // by pixel: whether its spot is known
  std::vector<float> lights_;        // negative: not computed
  const Room* room_ = nullptr;       // of the last floor pixel; neighbouring ones are mostly in the same
};

}  // namespace

Segmentation segmentation_of(const Scene& scene, const Profile& profile, Rays& rays) {
  const Camera camera = camera_of(scene.agent, profile);
  rays.build(solids_of(scene, camera, kEverywhere_m, hidden_from_sight(scene)));
  Segmentation image{camera.width, camera.height, {}};
  image.node.reserve(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height));
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const auto hit = rays.first(camera.at, camera.ray(x + 0.5, y + 0.5), kEverywhere_m);
      image.node.push_back(hit ? rays.solids()[hit->solid].owner : -1);
    }
  }
  return image;
}

namespace {

std::vector<std::size_t> hidden_in(const ViewedScene& viewed) {
  std::vector<std::size_t> hidden;
  for (std::size_t i = 0; i < viewed.scene.nodes.size(); ++i) {
    if (viewed.hides(i)) hidden.push_back(i);
  }
  return hidden;
}

}  // namespace

Picture picture_of(const Scene& scene, const Profile& profile, Rays& rays) {
  return picture_of(viewed(scene), profile, rays);
}

Picture picture_of(const ViewedScene& viewed, const Profile& profile, Rays& rays) {
  const Camera camera = camera_of(viewed.scene.agent, profile);
  rays.build(solids_of(viewed.scene, camera, kEverywhere_m, hidden_in(viewed), true));
  return Painter(viewed.scene, camera, rays).paint();
}

std::optional<std::size_t> node_at(const ViewedScene& viewed, const Profile& profile, int x, int y, Rays& rays) {
  const Camera camera = camera_of(viewed.scene.agent, profile);
  if (x < 0 || y < 0 || x >= camera.width || y >= camera.height) return std::nullopt;
  rays.build(solids_of(viewed.scene, camera, kEverywhere_m, hidden_in(viewed)));
  const auto hit = rays.first(camera.at, camera.ray(x + 0.5, y + 0.5), kEverywhere_m);
  if (!hit || rays.solids()[hit->solid].owner < 0) return std::nullopt;
  return static_cast<std::size_t>(rays.solids()[hit->solid].owner);
}

void draw_box(Picture& picture, const std::array<int, 4>& box, const std::array<std::uint8_t, 3>& colour) {
  const auto dot = [&](int x, int y) {
    const auto at =
        3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
    std::copy(colour.begin(), colour.end(), picture.rgb.begin() + static_cast<std::ptrdiff_t>(at));
  };
  for (int x = box[0]; x <= box[2]; ++x) {
    dot(x, box[1]);
    dot(x, box[3]);
  }
  for (int y = box[1]; y <= box[3]; ++y) {
    dot(box[0], y);
    dot(box[2], y);
  }
}

}  // namespace unietp
