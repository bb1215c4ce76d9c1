#include "grounding/floor_plan.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace unietp {
namespace {

constexpr double kShortestSide_m = 2.4, kCorridorSide_m = 1.7;
constexpr double kLongestAspect = 2.2, kCorridorAspect = 9;
constexpr double kOpeningMargin_m = 0.35;  // from a corner to the opening
constexpr double kMoreOpenings = 0.3;      // chance of one that the tree does not need
constexpr int kPassedThrough = 2;          // the highest passage of rooms that get one

struct Rect {
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();
  Vec2 size() const { return high - low; }
};

double round_to_dm(double metres) { return std::round(metres * 10) / 10; }

/// Cuts `rect` among the places of `order` in proportion to their areas.
void cut(const Rect& rect, std::vector<std::size_t> order, const std::vector<double>& areas, std::vector<Rect>& places,
         Rng& rng) {
  if (order.size() == 1) {
    places[order.front()] = rect;
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
  cut(first, {order.begin(), middle}, areas, places, rng);
  cut(second, {middle, order.end()}, areas, places, rng);
}

/// A rectangle cut in two again and again; every other time one corner of it stays out of doors.
std::optional<std::vector<Rect>> cut_plan(const std::vector<RoomRequest>& requests, Rng& rng) {
  std::vector<double> areas;
  for (const RoomRequest& request : requests) areas.push_back(request.area_m2);
  double total = std::accumulate(areas.begin(), areas.end(), 0.0);
  const bool notched = requests.size() > 2 && rng.chance(0.5);
  if (notched) areas.push_back(total * rng.uniform(0.07, 0.16));
  total = std::accumulate(areas.begin(), areas.end(), 0.0);
  const double width = round_to_dm(std::sqrt(total * rng.uniform(1.0, 1.6)));
  const Rect whole{Vec2::Zero(), {width, round_to_dm(total / width)}};
  std::vector<Rect> places(areas.size());
  std::vector<std::size_t> order(areas.size());
  std::iota(order.begin(), order.end(), 0);
  cut(whole, order, areas, places, rng);
  if (notched) {
    const Rect notch = places.back();
    places.pop_back();
    int sides = 0;
    for (int axis = 0; axis < 2; ++axis) {
      sides += notch.low[axis] == whole.low[axis] || notch.high[axis] == whole.high[axis] ? 1 : 0;
    }
    if (sides < 2) return std::nullopt;  // not at a corner
  }
  return places;
}

/// One row of rooms from x = 0 on; its depth follows from its length.
void lay_row(const std::vector<std::size_t>& row, const std::vector<RoomRequest>& requests, double length, double low,
             bool upwards, std::vector<Rect>& places) {
  double area = 0, done = 0;
  for (const std::size_t i : row) area += requests[i].area_m2;
  const double depth = round_to_dm(area / length);
  double from = 0;
  for (const std::size_t i : row) {
    done += requests[i].area_m2;
    const double to = round_to_dm(length * done / area);
    places[i] = upwards ? Rect{{from, low}, {to, low + depth}} : Rect{{from, low - depth}, {to, low}};
    from = to;
  }
}

/// Two rows of rooms along a corridor; nullopt without a corridor among the requests.
std::optional<std::vector<Rect>> corridor_plan(const std::vector<RoomRequest>& requests, Rng& rng) {
  std::vector<std::size_t> order;
  std::optional<std::size_t> spine;
  double area = 0;
  for (std::size_t i = 0; i < requests.size(); ++i) {
    if (!spine && requests[i].passage == 0) {
      spine = i;
      continue;
    }
    order.push_back(i);
    area += requests[i].area_m2;
  }
  if (!spine || order.size() < 4) return std::nullopt;
  rng.shuffle(order);
  std::vector<std::size_t> rows[2];
  double sums[2] = {0, 0};
  for (const std::size_t i : order) {
    const int row = sums[0] <= sums[1] ? 0 : 1;
    rows[row].push_back(i);
    sums[row] += requests[i].area_m2;
  }
  const double length = round_to_dm(std::sqrt(area * rng.uniform(1.3, 2.4)));
  const double other = rng.chance(0.5) ? length : round_to_dm(length * rng.uniform(0.75, 0.95));
  const double width = round_to_dm(std::clamp(requests[*spine].area_m2 / length, kCorridorSide_m, 2.1));
  std::vector<Rect> places(requests.size());
  places[*spine] = {{0, 0}, {length, width}};
  lay_row(rows[0], requests, length, width, true, places);
  lay_row(rows[1], requests, other, 0, false, places);
  return places;
}

bool well_formed(const std::vector<Rect>& places, const std::vector<RoomRequest>& requests) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool corridor = requests[i].passage == 0;
    const double shorter = places[i].size().minCoeff(), longer = places[i].size().maxCoeff();
    if (shorter < (corridor ? kCorridorSide_m : kShortestSide_m)) return false;
    if (longer > (corridor ? kCorridorAspect : kLongestAspect) * shorter) return false;
  }
  return true;
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

Vec2 point_on(const SharedWall& wall, double along) {
  Vec2 point;
  point[wall.axis] = along;
  point[1 - wall.axis] = wall.at;
  return point;
}

/// A spanning tree over the shared walls, plus some more; empty when the rooms do not hang together.
std::vector<SharedWall> choose_openings(std::vector<SharedWall> walls, const std::vector<RoomRequest>& requests,
                                        Rng& rng) {
  rng.shuffle(walls);
  const auto cost = [&](const SharedWall& wall) {
    const int a = requests[wall.a].passage, b = requests[wall.b].passage;
    return 10 * std::min(a, b) + std::max(a, b);
  };
  std::stable_sort(walls.begin(), walls.end(),
                   [&](const SharedWall& x, const SharedWall& y) { return cost(x) < cost(y); });
  std::vector<std::size_t> group(requests.size());
  std::iota(group.begin(), group.end(), 0);
  std::vector<SharedWall> chosen;
  for (const SharedWall& wall : walls) {
    if (group[wall.a] != group[wall.b]) {
      const std::size_t gone = group[wall.b];
      std::replace(group.begin(), group.end(), gone, group[wall.a]);
      chosen.push_back(wall);
    } else if (std::max(requests[wall.a].passage, requests[wall.b].passage) <= kPassedThrough &&
               rng.chance(kMoreOpenings)) {
      chosen.push_back(wall);
    }
  }
  const bool joined = std::all_of(group.begin(), group.end(), [&](std::size_t g) { return g == group.front(); });
  return joined ? chosen : std::vector<SharedWall>{};
}

/// Whether a room that nobody walks through has two openings.
bool leads_through_a_dead_end(const std::vector<SharedWall>& openings, const std::vector<RoomRequest>& requests) {
  for (std::size_t room = 0; room < requests.size(); ++room) {
    const auto doors = std::count_if(openings.begin(), openings.end(),
                                     [&](const SharedWall& wall) { return wall.a == room || wall.b == room; });
    if (requests[room].passage == kNoPassage && doors > 1) return true;
  }
  return false;
}

}  // namespace

std::optional<FloorPlan> draw_floor_plan(const std::vector<RoomRequest>& requests, Rng rng) {
  std::optional<std::vector<Rect>> rects;
  if (rng.chance(0.65)) rects = corridor_plan(requests, rng);
  if (!rects) rects = cut_plan(requests, rng);
  if (!rects || !well_formed(*rects, requests)) return std::nullopt;
  const auto chosen = choose_openings(shared_walls(*rects), requests, rng);
  if (chosen.empty() && requests.size() > 1) return std::nullopt;
  if (leads_through_a_dead_end(chosen, requests)) return std::nullopt;
  Vec2 corner = rects->front().low;
  for (const Rect& rect : *rects) corner = corner.cwiseMin(rect.low);

  FloorPlan plan;
  std::map<std::string, int> numbers;
  for (std::size_t i = 0; i < requests.size(); ++i) {
    const Vec2 low = (*rects)[i].low - corner, high = (*rects)[i].high - corner;
    const std::string& type = requests[i].type;
    plan.rooms.push_back(
        {type + "_" + std::to_string(++numbers[type]), type, {low, {high.x(), low.y()}, high, {low.x(), high.y()}}});
  }
  for (const SharedWall& wall : chosen) {
    const double from = rng.uniform(wall.from + kOpeningMargin_m, wall.to - kOpeningMargin_m - kOpeningWidth_m);
    plan.openings.push_back({"opening_" + std::to_string(plan.openings.size() + 1), plan.rooms[wall.a].id,
                             plan.rooms[wall.b].id, point_on(wall, from) - corner,
                             point_on(wall, from + kOpeningWidth_m) - corner, 2.0});
  }
  return plan;
}

std::vector<WallStretch> outer_walls(const Scene& scene, std::size_t room) {
  constexpr double kSame_m = 0.02;
  const Bounds own = room_bounds(scene.rooms[room], 1);
  std::vector<WallStretch> outer;
  for (int side = 0; side < 4; ++side) {
    const int across = side % 2 == 0 ? 1 : 0, along = 1 - across;
    const bool low_side = side == 0 || side == 3;
    const double at = low_side ? own.low[across] : own.high[across];
    std::vector<std::pair<double, double>> behind;
    for (std::size_t i = 0; i < scene.rooms.size(); ++i) {
      if (i == room) continue;
      const Bounds other = room_bounds(scene.rooms[i], 1);
      if (std::abs((low_side ? other.high[across] : other.low[across]) - at) > kSame_m) continue;
      behind.emplace_back(other.low[along], other.high[along]);
    }
    std::sort(behind.begin(), behind.end());
    double from = own.low[along];
    for (const auto& [low, high] : behind) {
      if (low > from) outer.push_back({side, from, std::min(low, own.high[along])});
      from = std::max(from, high);
      if (from >= own.high[along]) break;
    }
    if (from < own.high[along]) outer.push_back({side, from, own.high[along]});
  }
  std::erase_if(outer, [](const WallStretch& wall) { return wall.to - wall.from < 0.3; });
  return outer;
}

}  // namespace unietp
