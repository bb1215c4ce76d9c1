#include "grounding/floor_plan.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace unietp {
namespace {

constexpr double kShortestSide_m = 2.4;
constexpr double kLongestAspect = 2.4;
constexpr double kOpeningMargin_m = 0.35;  // from a corner to the opening

struct Rect {
  Vec2 low, high;
  Vec2 size() const { return high - low; }
};

/// Usual floor area by type in m²: medians of the MIT-licensed VirtualHome apartments and of Apache-licensed ProcTHOR
/// houses, rounded, corridors widened so that furniture fits.
double usual_area(std::string_view type) {
  static const std::vector<std::pair<std::string_view, double>> areas{
      {"living_room", 24}, {"kitchen", 19},  {"bedroom", 18}, {"dining_room", 16},
      {"office", 14},      {"bathroom", 12}, {"corridor", 11}};
  for (const auto& [name, area] : areas) {
    if (name == type) return area;
  }
  return 14;
}

double round_to_dm(double metres) { return std::round(metres * 10) / 10; }

/// Cuts `rect` among the rooms of `order` in proportion to their areas.
void cut(const Rect& rect, std::vector<std::size_t> order, const std::vector<double>& areas, std::vector<Rect>& rooms,
         Rng& rng) {
  if (order.size() == 1) {
    rooms[order.front()] = rect;
    return;
  }
  rng.shuffle(order);
  const auto sum = [&](std::size_t from, std::size_t to) {
    double total = 0;
    for (std::size_t i = from; i < to; ++i) total += areas[order[i]];
    return total;
  };
  const double total = sum(0, order.size());
  std::size_t best = 1;
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (std::abs(sum(0, k) - total / 2) < std::abs(sum(0, best) - total / 2)) best = k;
  }
  const int axis = rect.size().x() >= rect.size().y() ? 0 : 1;
  const double at = round_to_dm(rect.low[axis] + rect.size()[axis] * sum(0, best) / total);
  Rect first = rect, second = rect;
  first.high[axis] = at;
  second.low[axis] = at;
  const auto middle = order.begin() + static_cast<std::ptrdiff_t>(best);
  cut(first, {order.begin(), middle}, areas, rooms, rng);
  cut(second, {middle, order.end()}, areas, rooms, rng);
}

struct SharedWall {
  std::size_t a, b;
  int axis;         // the wall runs along this axis
  double at;        // coordinate on the other axis
  double from, to;  // along the wall
};

std::vector<SharedWall> shared_walls(const std::vector<Rect>& rooms) {
  std::vector<SharedWall> walls;
  for (std::size_t a = 0; a < rooms.size(); ++a) {
    for (std::size_t b = 0; b < rooms.size(); ++b) {
      for (int axis = 0; axis < 2 && a != b; ++axis) {
        const int across = 1 - axis;
        if (std::abs(rooms[a].high[across] - rooms[b].low[across]) > 1e-9) continue;
        const double from = std::max(rooms[a].low[axis], rooms[b].low[axis]);
        const double to = std::min(rooms[a].high[axis], rooms[b].high[axis]);
        if (to - from < kOpeningWidth_m + 2 * kOpeningMargin_m) continue;
        walls.push_back({a, b, axis, rooms[a].high[across], from, to});
      }
    }
  }
  return walls;
}

bool is_hub(std::string_view type) { return type == "living_room" || type == "corridor"; }

Vec2 point_on(const SharedWall& wall, double along) {
  Vec2 point;
  point[wall.axis] = along;
  point[1 - wall.axis] = wall.at;
  return point;
}

/// A spanning tree over the shared walls, hubs first, plus some more; empty when the rooms do not hang together.
std::vector<SharedWall> choose_openings(std::vector<SharedWall> walls, const std::vector<std::string>& types,
                                        Rng& rng) {
  rng.shuffle(walls);
  std::stable_sort(walls.begin(), walls.end(), [&](const SharedWall& x, const SharedWall& y) {
    const auto hubs = [&](const SharedWall& w) { return is_hub(types[w.a]) || is_hub(types[w.b]); };
    return hubs(x) && !hubs(y);
  });
  std::vector<std::size_t> group(types.size());
  std::iota(group.begin(), group.end(), 0);
  std::vector<SharedWall> chosen;
  for (const SharedWall& wall : walls) {
    if (group[wall.a] != group[wall.b]) {
      std::replace(group.begin(), group.end(), group[wall.b], group[wall.a]);
      chosen.push_back(wall);
    } else if (rng.chance(0.15)) {
      chosen.push_back(wall);
    }
  }
  const bool joined = std::all_of(group.begin(), group.end(), [&](std::size_t g) { return g == group.front(); });
  return joined ? chosen : std::vector<SharedWall>{};
}

}  // namespace

std::optional<FloorPlan> draw_floor_plan(const std::vector<std::string>& types, Rng rng) {
  std::vector<double> areas;
  for (const auto& type : types) areas.push_back(usual_area(type) * rng.uniform(0.9, 1.15));
  const double total = std::accumulate(areas.begin(), areas.end(), 0.0);
  const double width = round_to_dm(std::sqrt(total * rng.uniform(1.0, 1.6)));
  const Rect whole{Vec2::Zero(), {width, round_to_dm(total / width)}};
  std::vector<Rect> rects(types.size());
  std::vector<std::size_t> order(types.size());
  std::iota(order.begin(), order.end(), 0);
  cut(whole, order, areas, rects, rng);
  for (const Rect& rect : rects) {
    const double shorter = rect.size().minCoeff(), longer = rect.size().maxCoeff();
    const double area = shorter * longer;
    if (shorter < kShortestSide_m || longer > kLongestAspect * shorter || area < 9 || area > 30) return std::nullopt;
  }
  const auto chosen = choose_openings(shared_walls(rects), types, rng);
  if (chosen.empty() && types.size() > 1) return std::nullopt;

  FloorPlan plan;
  std::map<std::string, int> numbers;
  for (std::size_t i = 0; i < types.size(); ++i) {
    const auto& [low, high] = rects[i];
    plan.rooms.push_back({types[i] + "_" + std::to_string(++numbers[types[i]]),
                          types[i],
                          {low, {high.x(), low.y()}, high, {low.x(), high.y()}}});
  }
  for (const SharedWall& wall : chosen) {
    const double from = rng.uniform(wall.from + kOpeningMargin_m, wall.to - kOpeningMargin_m - kOpeningWidth_m);
    plan.openings.push_back({"opening_" + std::to_string(plan.openings.size() + 1), plan.rooms[wall.a].id,
                             plan.rooms[wall.b].id, point_on(wall, from), point_on(wall, from + kOpeningWidth_m), 2.0});
  }
  return plan;
}

Bounds room_bounds(const Room& room, double height) {
  Vec2 low = room.polygon.front(), high = low;
  for (const Vec2& corner : room.polygon) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  return {{low.x(), low.y(), 0}, {high.x(), high.y(), height}};
}

}  // namespace unietp
