#include "interchange/house_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace unietp {
namespace {

constexpr double kOnLine_m = 0.02, kShortest_m = 0.02, kBehind_m = 0.05;

/// Distances from `start` of all corners that lie on the line between the ends, both ends included, ascending.
std::vector<double> cuts_of(const Scene& scene, const Vec2& start, const Vec2& along, double length) {
  std::vector<double> cuts{0, length};
  const Vec2 across(-along.y(), along.x());
  for (const Room& room : scene.rooms) {
    for (const Vec2& corner : room.polygon) {
      const double at = (corner - start).dot(along);
      if (std::abs((corner - start).dot(across)) < kOnLine_m && at > kShortest_m && at < length - kShortest_m) {
        cuts.push_back(at);
      }
    }
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end(), [](double a, double b) { return b - a < kShortest_m; }), cuts.end());
  return cuts;
}

}  // namespace

std::vector<WallPart> wall_parts(const Scene& scene) {
  std::vector<WallPart> parts;
  for (std::size_t r = 0; r < scene.rooms.size(); ++r) {
    const auto& polygon = scene.rooms[r].polygon;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 start = polygon[i], whole = polygon[(i + 1) % polygon.size()] - start;
      const double length = whole.norm();
      if (length < kShortest_m) continue;
      const Vec2 along = whole / length, out(along.y(), -along.x());
      const auto cuts = cuts_of(scene, start, along, length);
      for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
        WallPart part{r, std::nullopt, start + cuts[k] * along, start + cuts[k + 1] * along};
        const Room* behind = room_at(scene, (part.from + part.to) / 2 + kBehind_m * out);
        if (behind != nullptr && behind != &scene.rooms[r]) part.behind = behind - scene.rooms.data();
        parts.push_back(part);
      }
    }
  }
  return parts;
}

std::optional<OnWall> nearest_wall(const std::vector<WallPart>& parts, const Vec2& point, double reach,
                                   std::optional<std::size_t> room, std::optional<std::size_t> behind) {
  std::optional<OnWall> best;
  double nearest = reach;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const WallPart& part = parts[i];
    if ((room && part.room != *room) || (behind && part.behind != behind)) continue;
    const double length = (part.to - part.from).norm();
    const Vec2 along = (part.to - part.from) / length;
    const double at = (point - part.from).dot(along);
    const double off = std::abs((point - part.from).dot(Vec2(-along.y(), along.x())));
    if (at < 0 || at > length || off >= nearest) continue;
    nearest = off;
    best = OnWall{i, at};
  }
  return best;
}

}  // namespace unietp
