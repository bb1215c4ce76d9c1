#include "simulation/view.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "simulation/camera.h"
#include "simulation/navigation.h"
#include "simulation/solids.h"

namespace unietp {
namespace {

using Box = std::array<int, 4>;  // x0, y0, x1, y1: both ends included

/// Pixels that an object may cover, from its solids' corners; the whole image when one lies behind the camera.
struct Cover {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity()), high = -low;
  bool behind = false;

  void add(const Solid& solid, const Camera& camera) {
    const Vec3 half = solid.size / 2;
    for (int i = 0; i < 8 && !behind; ++i) {
      const Vec3 corner((i & 1) ? half.x() : -half.x(), (i & 2) ? half.y() : -half.y(), (i & 4) ? half.z() : -half.z());
      const auto pixel = camera.pixel(solid.pose * corner);
      behind = !pixel;
      if (!pixel) break;
      low = low.cwiseMin(*pixel);
      high = high.cwiseMax(*pixel);
    }
  }
  /// nullopt when it lies beside the image.
  std::optional<Box> box(const Camera& camera) const {
    if (behind) return Box{0, 0, camera.width - 1, camera.height - 1};
    if (low.x() >= camera.width || low.y() >= camera.height || high.x() < 0 || high.y() < 0) return std::nullopt;
    const auto clip = [](double value, int size) {
      return static_cast<int>(std::clamp(std::floor(value), 0.0, static_cast<double>(size - 1)));
    };
    return Box{clip(low.x(), camera.width), clip(low.y(), camera.height), clip(high.x(), camera.width),
               clip(high.y(), camera.height)};
  }
};

/// Looks through single pixels and remembers for each object the box around those that show it.
class Looker {
 public:
  Looker(const Camera& camera, const Rays& rays, double farthest, std::size_t nodes)
      : camera_(camera),
        rays_(rays),
        farthest_(farthest),
        shown_(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height), kNotAsked),
        boxes_(nodes) {}

  /// Node that a pixel shows; negative for none.
  std::int32_t at(int x, int y) {
    std::int32_t& shown =
        shown_[static_cast<std::size_t>(y) * static_cast<std::size_t>(camera_.width) + static_cast<std::size_t>(x)];
    if (shown != kNotAsked) return shown;
    const auto hit = rays_.first(camera_.at, camera_.ray(x + 0.5, y + 0.5), farthest_);
    shown = hit ? rays_.solids()[hit->solid].owner : -1;
    if (shown < 0) return shown;
    std::optional<Box>& box = boxes_[static_cast<std::size_t>(shown)];
    box = box ? Box{std::min((*box)[0], x), std::min((*box)[1], y), std::max((*box)[2], x), std::max((*box)[3], y)}
              : Box{x, y, x, y};
    return shown;
  }
  const std::optional<Box>& box_of(std::size_t node) const { return boxes_[node]; }

  /// A grid over the cover, finer where that is only a guess, and the points that give an object away.
  void sample(const Node& node, const Box& cover, bool guessed) {
    const int across = guessed ? 20 : 5;
    const int dx = std::max(1, (cover[2] - cover[0]) / across), dy = std::max(1, (cover[3] - cover[1]) / across);
    for (int y = cover[1] + dy / 2; y <= cover[3]; y += dy) {
      for (int x = cover[0] + dx / 2; x <= cover[2]; x += dx) at(x, y);
    }
    for (const Vec3& point : sight_points(node)) {
      const auto pixel = camera_.pixel(point);
      if (!pixel || (pixel->array() < 0).any() || pixel->x() >= camera_.width || pixel->y() >= camera_.height) continue;
      at(static_cast<int>(pixel->x()), static_cast<int>(pixel->y()));
    }
  }

  /// Moves one side of an object's box (0 left, 1 top, 2 right, 3 bottom) outwards, by halves of what the cover leaves.
  void grow(std::size_t node, const Box& cover, std::size_t side) {
    constexpr int kAlong = 12;
    const bool upright = side % 2 == 0;
    const int low = cover[upright ? 1 : 0], high = cover[upright ? 3 : 2];
    const int stride = std::max(2, (high - low) / kAlong);
    int limit = cover[side];
    while (limit != (*boxes_[node])[side]) {
      const int here = (*boxes_[node])[side], outwards = limit < here ? -1 : 1;
      const int line = here + outwards * std::max(1, std::abs(limit - here) / 2);
      bool met = false;
      for (int along = low; along <= high && !met; along += stride)
        met = (upright ? at(line, along) : at(along, line)) == static_cast<std::int32_t>(node);
      if (!met) limit = line - outwards;
    }
  }

 private:
  static constexpr std::int32_t kNotAsked = -2;
  const Camera& camera_;
  const Rays& rays_;
  double farthest_;
  std::vector<std::int32_t> shown_;
  std::vector<std::optional<Box>> boxes_;
};

}  // namespace

std::vector<VisibleObject> view_of(const Scene& scene, const Profile& profile, Rays& rays) {
  const Camera camera = camera_of(scene.agent, profile);
  const std::vector<std::string> hidden = hidden_from_sight(scene);
  std::vector<bool> asked(scene.nodes.size(), false);
  double farthest = 0;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    const double distance = (node.pose.position - camera.at).norm();
    if (distance > profile.sight_m || std::binary_search(hidden.begin(), hidden.end(), node.id)) continue;
    asked[i] = true;
    farthest = std::max(farthest, distance + sight_radius(node));
  }
  rays.build(solids_of(scene, camera, farthest, hidden));

  std::vector<Cover> covers(scene.nodes.size());
  for (const Solid& solid : rays.solids()) {
    if (solid.owner >= 0) covers[static_cast<std::size_t>(solid.owner)].add(solid, camera);
  }
  Looker looker(camera, rays, farthest, scene.nodes.size());
  std::vector<std::optional<Box>> boxes(scene.nodes.size());
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (!asked[i]) continue;
    boxes[i] = covers[i].box(camera);
    if (boxes[i]) looker.sample(scene.nodes[i], *boxes[i], covers[i].behind);
  }
  // A ray of one object may be the first to meet another: until all that were met have been grown.
  std::vector<bool> grown(scene.nodes.size(), false);
  for (bool again = true; again;) {
    again = false;
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
      if (!boxes[i] || grown[i] || !looker.box_of(i)) continue;
      grown[i] = again = true;
      for (std::size_t side = 0; side < 4; ++side) looker.grow(i, *boxes[i], side);
    }
  }
  std::vector<VisibleObject> visible;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (asked[i] && looker.box_of(i)) visible.push_back({scene.nodes[i].id, *looker.box_of(i)});
  }
  std::sort(visible.begin(), visible.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  return visible;
}

}  // namespace unietp
