#include "simulation/picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

#include "simulation/camera.h"
#include "simulation/daylight.h"
#include "simulation/first_solids.h"
#include "simulation/glow.h"
#include "simulation/noise.h"
#include "simulation/room_paint.h"
#include "simulation/solids.h"
#include "simulation/walls.h"

namespace unietp {
namespace {

constexpr double kEverywhere_m = 1000;
constexpr double kShadow_m = 0.8;     // longest shadow
constexpr double kLamps_m = 9;        // farther lamps are not lit, but from above
constexpr double kLeastClear = 0.15;  // of stains and cracks on glass: what is behind it is still seen
const Vec3 kSun = Vec3(0.35, 0.2, 0.9).normalized();

// What a pixel shows besides solids, in the place of their numbers.
struct Shell {
  static constexpr std::int32_t kOpen = -1, kFloor = -2, kCeiling = -3;
};

bool same_face(const PixelHit& a, const PixelHit& b) { return a.solid == b.solid && a.normal == b.normal; }

/// The look of the room of the last pixel: neighboring ones are mostly in the same.
class RoomOfLastPixel {
 public:
  const RoomPaint& paint_at(const Scene& scene, const Vec2& place) {
    if (room_ == nullptr || !contains(room_->polygon, place)) {
      room_ = room_at(scene, place);
      paint_ = room_paint(room_);
    }
    return paint_;
  }

 private:
  const Room* room_ = nullptr;
  RoomPaint paint_ = room_paint(nullptr);
};

class Painter {
 public:
  Painter(const Scene& scene, const Camera& camera, const Rays& rays, const std::vector<Node>& in_hand)
      : scene_(scene), camera_(camera), rays_(rays), lights_(size(), kDark) {
    find_looks(in_hand);
    const double lit = std::max(kLamps_m, 2 * camera.at.z());
    sources_ = light_sources(scene, looks_, camera, lit);
    windows_ = daylight_of(scene, camera, lit);
  }

  Picture paint(const std::vector<std::size_t>& hidden) {
    find_spots();
    Picture picture{camera_.width, camera_.height, {}};
    picture.rgb.reserve(3 * size());
    for (int y = 0; y < camera_.height; ++y) {
      for (int x = 0; x < camera_.width; ++x) {
        const Color color = color_at(x, y) * rim_at(x, y);
        for (int c = 0; c < 3; ++c) picture.rgb.push_back(byte_of(color[c]));
      }
    }
    for (std::size_t i = 0; i < looks_.size(); ++i) {
      if (std::binary_search(hidden.begin(), hidden.end(), i)) continue;
      for (const Puff& puff : puffs_of(scene_.nodes[i], looks_[i])) blow(puff, picture);
    }
    return picture;
  }

 private:
  /// Of what may be in the picture, and of what lights or steams into it.
  void find_looks(const std::vector<Node>& in_hand) {
    bodies_.resize(scene_.nodes.size());
    looks_.resize(scene_.nodes.size());
    std::vector<std::uint8_t> shown(scene_.nodes.size(), 0);
    edges_.reserve(rays_.solids().size());
    for (const Solid& solid : rays_.solids()) {
      edges_.push_back({solid.owner, solid.skin == Skin::Water || solid.skin == Skin::Flame});
      if (solid.owner >= 0) shown[static_cast<std::size_t>(solid.owner)] = 1;
    }
    for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
      const Node& node = scene_.nodes[i];
      if (!shown[i] && !node.states.has(Predicate::PowerOn) && !node.states.has(Predicate::Hot)) continue;
      const auto held =
          std::find_if(in_hand.begin(), in_hand.end(), [&](const Node& one) { return one.id == node.id; });
      const Node& seen = held == in_hand.end() ? node : *held;
      bodies_[i] = {seen.pose.rotation.toRotationMatrix().transpose(), seen.pose.position};
      looks_[i] = look_of(seen, family_of(seen, scene_.simulator));
    }
    for (const Solid& solid : rays_.solids()) {
      if (solid.skin == Skin::Liquid) looks_[static_cast<std::size_t>(solid.owner)].pool = true;
    }
  }

  std::size_t size() const {
    return static_cast<std::size_t>(camera_.width) * static_cast<std::size_t>(camera_.height);
  }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(camera_.width) + static_cast<std::size_t>(x);
  }
  Vec3 way(int x, int y) const { return camera_.ray(x + 0.5, y + 0.5); }

  PixelHit shell(const Vec3& from, const Vec3& direction) const {
    const auto plane = plane_behind(from, direction, scene_.wall_height);
    if (!plane) return {};
    return plane->is_floor ? PixelHit{Shell::kFloor, plane->along, Vec3::UnitZ()}
                           : PixelHit{Shell::kCeiling, plane->along, -Vec3::UnitZ()};
  }

  void find_spots() {
    spots_ = first_solids(rays_.solids(), camera_);
    for (int y = 0; y < camera_.height; ++y) {
      for (int x = 0; x < camera_.width; ++x) {
        PixelHit& spot = spots_[index(x, y)];
        if (spot.solid < 0) spot = shell(camera_.at, way(x, y));
      }
    }
  }

  /// Rounded; never negative, and `lround` would be a call for each pixel.
  static std::uint8_t byte_of(double value) {
    return static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0) + 0.5);  // NOLINT(bugprone-incorrect-roundings)
  }

  Color color_at(int x, int y) { return color_of(spots_[index(x, y)], way(x, y), light_at(x, y), 0); }

  /// Of a spot on a ray from the camera, lit, with what is seen through it. `through`: how many clear solids lie before
  /// it.
  Color color_of(const PixelHit& spot, const Vec3& direction, const Vec3& light, int through) {
    constexpr int kMostThrough = 64;  // bounds the recursion; so much glass lets nothing through that could be seen
    const Vec3 at = camera_.at + spot.depth * direction;
    const Finish finish = finish_at(spot, at, direction);
    if (finish.glows) return finish.color;
    Color color = finish.color.cwiseProduct(light);
    if (finish.clear > 0 && through < kMostThrough) {
      const SolidHit here{spot.depth, static_cast<std::size_t>(spot.solid), spot.normal};
      const auto hit = rays_.next(camera_.at, direction, kEverywhere_m, here);
      const PixelHit next =
          hit ? PixelHit{static_cast<std::int32_t>(hit->solid), hit->along, hit->normal} : shell(camera_.at, direction);
      const Color behind = color_of(next, direction, lit(next, direction), through + 1);
      color = mixed(color, behind.cwiseProduct(Vec3(0.94, 0.98, 1.0)), finish.clear);
    }
    return finish.gloss > 0 ? shining(color, finish.gloss, spot.normal, direction) : color;
  }

  /// Reflections of the lamp, and of a bright ceiling above a darker floor.
  static Color shining(const Color& color, double gloss, const Vec3& normal, const Vec3& direction) {
    const Vec3 eye = direction.normalized(), mirrored = eye - 2 * eye.dot(normal) * normal;
    const double above = ramp(-0.35, 0.75, mirrored.z()), square = gloss * gloss;
    const double lamp = std::max(0.0, mirrored.dot(kSun));
    const double two = lamp * lamp, four = two * two, eight = four * four;
    return color * (1 - 0.42 * square * (1 - above)) +
           Color::Constant(150 * gloss * eight * eight + 34 * square * above);
  }

  /// Whether a point of a door's front is on its handle.
  static bool on_handle(const Solid& solid, const SurfacePoint& point) {
    constexpr double kFromEdge_m = 0.05, kWide_m = 0.012, kLong_m = 0.11;
    if (solid.handle == 0 || point.normal.y() > -0.7) return false;
    const Vec3 half = solid.size / 2;
    const double length = std::min(kLong_m, 0.6 * half.z());
    if (solid.handle == 2)
      return std::abs(point.at.x()) < std::min(kLong_m, 0.3 * half.x()) && std::abs(point.at.z()) < kWide_m;
    return std::abs(point.at.x() - solid.handle * (half.x() - std::min(kFromEdge_m, half.x() / 4))) < kWide_m &&
           std::abs(point.at.z()) < length;
  }

  static Look coated(Look look, const Solid& solid) {
    if (solid.color) {
      const Rgb& rgb = *solid.color;
      look.base = Color(rgb[0], rgb[1], rgb[2]);
    } else {
      look.base = (look.base * solid.shade).cwiseMin(250);
    }
    if (solid.matter) look.matter = *solid.matter;
    return look;
  }

  Finish finish_at(const PixelHit& spot, const Vec3& at, const Vec3& direction) {
    if (spot.solid == Shell::kOpen) return {kOpenPaint, 0, 0, true};
    if (spot.solid == Shell::kCeiling) return {kCeilingPaint};
    const double pixel_m = spot.depth * direction.norm() / camera_.focal;
    if (spot.solid == Shell::kFloor) {
      const Vec2 place = at.head<2>();
      return {floor_paint(floors_.paint_at(scene_, place), place, pixel_m)};
    }
    const Solid& solid = rays_.solids()[static_cast<std::size_t>(spot.solid)];
    if (solid.owner < 0) {
      constexpr double kBefore_m = 0.05;  // on the side from which it is seen, past the wall's thickness
      const Vec2 before = (at + (scene_.wall_thickness / 2 + kBefore_m) * spot.normal).head<2>();
      return {wall_paint(walls_.paint_at(scene_, before), at, scene_.wall_height, pixel_m)};
    }
    const auto owner = static_cast<std::size_t>(solid.owner);
    const Body& body = bodies_[owner];
    const bool own = solid.color || solid.matter || solid.shade != 1;
    Look changed;
    if (own) changed = coated(looks_[owner], solid);
    const Look& look = own ? changed : looks_[owner];
    SurfacePoint point;
    point.skin = solid.skin;
    point.moves = solid.moves;
    point.pixel_m = pixel_m;
    if (solid.moves || solid.skin != Skin::Body) {
      const Quat back = solid.pose.rotation.conjugate();
      point.at = rotated(back, at - solid.pose.position);
      point.normal = rotated(back, spot.normal);
      point.inner = point.at.cwiseQuotient(solid.size / 2);
    } else {
      point.at = body.to_own * (at - body.center);
      point.normal = body.to_own * spot.normal;
      point.inner = point.at.cwiseQuotient(look.half);
    }
    Finish finish = finish_of(look, point);
    finish.clear = solid.clear ? std::max(finish.clear, kLeastClear) : 0;
    constexpr double kDoor = 0.93;  // doors are slightly darker than the body
    if (solid.moves && !finish.glows) finish.color *= kDoor;
    if (on_handle(solid, point)) finish = {{62, 62, 66}, 0.6};
    return finish;
  }

  /// Computed once for two by two pixels that show one face.
  Vec3 light_at(int x, int y) {
    const int x0 = x & ~1, y0 = y & ~1;
    const bool same = same_face(spots_[index(x, y)], spots_[index(x0, y0)]);
    const int lx = same ? x0 : x, ly = same ? y0 : y;
    Eigen::Vector3f& light = lights_[index(lx, ly)];
    if (light.x() < 0) light = lit(spots_[index(lx, ly)], way(lx, ly)).cast<float>();
    return light.cast<double>();
  }

  /// Ambient light, light from the camera, light from above where it is not blocked, that of lamps, and daylight
  /// through windows. Shadows are darkest where the thing that casts them touches.
  Vec3 lit(const PixelHit& spot, const Vec3& direction) const {
    if (spot.solid == Shell::kOpen) return Vec3::Ones();
    const double facing = std::abs(spot.normal.dot(direction.normalized()));
    const Vec3 at = camera_.at + spot.depth * direction;
    const Vec3 lamps = sources_.empty() ? Vec3(Vec3::Zero()) : light_of(sources_, at, spot.normal);
    if (spot.solid == Shell::kCeiling) return Vec3::Constant(0.9 + 0.1 * facing) + 0.3 * lamps;
    constexpr double kAround = 0.48, kEye = 0.24, kAbove = 0.3, kLift_m = 0.001, kCorner = 0.16, kCorner_m = 0.25;
    const double above = spot.normal.dot(kSun);
    double sun = above > 0 ? above : 0, around = kAround;
    if (above > 0) {
      const auto hit = rays_.first(at + kLift_m * spot.normal, kSun, kShadow_m);
      if (hit) {
        const double near = 1 - hit->along / kShadow_m;
        sun *= 1 - ramp(0, 0.6, near);
        around *= 1 - 0.35 * near * near;
      }
    } else {
      around -= kCorner * (1 - ramp(0, kCorner_m, at.z()));  // less light comes near the floor
    }
    Vec3 light = Vec3::Constant(around + kEye * facing + kAbove * sun) + lamps;
    if (!windows_.empty()) light += daylight(at, spot.normal);
    return light;
  }

  Vec3 daylight(const Vec3& at, const Vec3& normal) const {
    constexpr double kLift_m = 0.001, kPane_m = 0.15, kSunlight = 0.6;
    Vec3 light = sky_light(windows_, at, normal);
    const double facing = normal.dot(toward_sun());
    if (facing <= 0) return light;
    const auto way = way_to_sunny_pane(windows_, at);
    if (way && !rays_.first(at + kLift_m * normal, toward_sun(), *way - kPane_m))
      light += kSunlight * facing * Vec3(1, 0.95, 0.8);
    return light;
  }

  /// Lays a puff over the picture, where nothing is nearer.
  void blow(const Puff& puff, Picture& picture) const {
    const auto middle = camera_.pixel(puff.at);
    if (!middle) return;
    const double depth = camera_.depth(puff.at), radius = camera_.focal * puff.radius / depth;
    const auto first = [&](double at) { return std::max(0, static_cast<int>(std::max(0.0, at - radius))); };
    const auto last = [&](double at, int pixels) { return static_cast<int>(std::min(pixels - 1.0, at + radius)); };
    for (int y = first(middle->y()); y <= last(middle->y(), camera_.height); ++y) {
      for (int x = first(middle->x()); x <= last(middle->x(), camera_.width); ++x) {
        const double away = (Vec2(x + 0.5, y + 0.5) - *middle).squaredNorm() / (radius * radius);
        if (away >= 1 || spots_[index(x, y)].depth < depth - puff.radius) continue;
        const double share = puff.strength * (1 - away) * (1 - away);
        for (std::size_t c = 0; c < 3; ++c) {
          std::uint8_t& value = picture.rgb[3 * index(x, y) + c];
          value = byte_of(value + share * (puff.color[static_cast<Eigen::Index>(c)] - value));
        }
      }
    }
  }

  /// Darkens outlines of objects, and less so edges between faces.
  double rim_at(int x, int y) const {
    const PixelHit& here = spots_[index(x, y)];
    constexpr double kEnd = 0.55, kFold = 0.85;
    double rim = 1;
    for (const auto& [nx, ny] : {std::pair{x + 1, y}, std::pair{x, y + 1}}) {
      if (nx >= camera_.width || ny >= camera_.height) continue;
      const PixelHit& there = spots_[index(nx, ny)];
      if (same_face(here, there)) continue;
      const Edge a = edge_of(here), b = edge_of(there);
      if (a.none || b.none) continue;
      if (a.owner != b.owner) {
        rim = std::min(rim, kEnd);
      } else if (here.solid >= 0 && there.solid >= 0) {
        constexpr double kStep = 0.02, kTurn = 0.8;
        const bool apart = std::abs(here.depth - there.depth) > kStep + kStep * here.depth;
        if (apart || here.normal.dot(there.normal) < kTurn) rim = std::min(rim, kFold);
      }
    }
    return rim;
  }

  /// What a solid's outlines depend on.
  struct Edge {
    std::int32_t owner = -1;
    bool none = false;  // water and flames have no outlines
  };
  /// Walls, floor, ceiling and openings have owners of their own.
  Edge edge_of(const PixelHit& spot) const {
    return spot.solid < 0 ? Edge{spot.solid - 1} : edges_[static_cast<std::size_t>(spot.solid)];
  }

  const Scene& scene_;
  const Camera& camera_;
  const Rays& rays_;
  struct Body {
    Eigen::Matrix3d to_own;
    Vec3 center;
  };
  inline static const Eigen::Vector3f kDark{-1, -1, -1};  // not computed
  std::vector<Body> bodies_;                              // of the nodes
  std::vector<Look> looks_;                               // of the nodes
  std::vector<Edge> edges_;                               // of the solids
  std::vector<LightSource> sources_;
  std::vector<Daylight> windows_;
  std::vector<PixelHit> spots_;
  std::vector<Eigen::Vector3f> lights_;
  RoomOfLastPixel floors_, walls_;
};

std::vector<std::size_t> hidden_in(const ViewedScene& viewed) {
  std::vector<std::size_t> hidden;
  for (std::size_t i = 0; i < viewed.scene.nodes.size(); ++i) {
    if (viewed.hides(i)) hidden.push_back(i);
  }
  return hidden;
}

/// What the agent holds, as it is seen in its hands: in the lower corners, made small enough to leave the view free.
std::vector<Node> held_before(const Scene& scene, const Camera& camera) {
  constexpr double kMost_m = 0.13, kAhead_m = 0.5, kAside = 0.8, kDown = 0.78;  // parts of the image's half
  std::vector<Node> held;
  for (const std::string& id : scene.agent.held) {
    const Node* known = find_node(scene, id);
    if (known == nullptr) continue;
    Node node = *known;
    const double small = std::min(1.0, kMost_m / node.size.maxCoeff());
    node.size *= small;
    for (Board& board : node.boards) board.center *= small, board.size *= small;
    const double aside = kAside * camera.width / 2 / camera.focal, down = kDown * camera.height / 2 / camera.focal;
    const double side = held.empty() ? 1 : -1;
    node.pose = upright(camera.at + kAhead_m * (camera.ahead + side * aside * camera.right + down * camera.down),
                        std::atan2(-camera.right.x(), camera.right.y()) - std::numbers::pi / 2);
    held.push_back(std::move(node));
  }
  return held;
}

std::int32_t owner_of(const Scene& scene, std::string_view id) {
  const auto found =
      std::find_if(scene.nodes.begin(), scene.nodes.end(), [&](const Node& node) { return node.id == id; });
  return static_cast<std::int32_t>(found - scene.nodes.begin());
}

}  // namespace

Picture picture_of(const Scene& scene, const Profile& profile, Rays& rays) {
  return picture_of(viewed(scene), profile, rays);
}

Picture picture_of(const ViewedScene& viewed, const Profile& profile, Rays& rays) {
  return picture_of(viewed, camera_of(viewed.scene.agent, profile), rays);
}

Picture picture_of(const ViewedScene& viewed, const Camera& camera, Rays& rays) {
  const auto hidden = hidden_in(viewed);
  auto solids = solids_of(viewed.scene, camera, kEverywhere_m, hidden);
  const auto in_hand = held_before(viewed.scene, camera);
  for (const Node& node : in_hand)
    add_solids(node, owner_of(viewed.scene, node.id), viewed.scene.simulator, {}, solids);
  rays.build(std::move(solids));
  return Painter(viewed.scene, camera, rays, in_hand).paint(hidden);
}

std::optional<std::size_t> node_at(const ViewedScene& viewed, const Profile& profile, int x, int y, Rays& rays) {
  const Camera camera = camera_of(viewed.scene.agent, profile);
  if (x < 0 || y < 0 || x >= camera.width || y >= camera.height) return std::nullopt;
  rays.build(solids_of(viewed.scene, camera, kEverywhere_m, hidden_in(viewed)));
  const auto hit = rays.first(camera.at, camera.ray(x + 0.5, y + 0.5), kEverywhere_m);
  if (!hit || rays.solids()[hit->solid].owner < 0) return std::nullopt;
  return static_cast<std::size_t>(rays.solids()[hit->solid].owner);
}

void draw_box(Picture& picture, const std::array<int, 4>& box, const std::array<std::uint8_t, 3>& color) {
  const auto dot = [&](int x, int y) {
    const auto at =
        3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
    std::copy(color.begin(), color.end(), picture.rgb.begin() + static_cast<std::ptrdiff_t>(at));
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
