#include "grounding/floor_plan.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace unietp {
namespace {

constexpr double kShortestSide_m = 2.4, kCorridorSide_m = 1.5;
constexpr double kWidestCorridor_m = 1.9;
constexpr double kLongestAspect = 2.2, kCorridorAspect = 10;
constexpr double kOpeningMargin_m = 0.35;     // from a corner to the opening
constexpr double kInRows = 0.45, kCut = 0.1;  // of homes with a corridor; the others have a wing
constexpr const char* kCorridor = "corridor";

struct Rect {
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();
  Vec2 size() const { return high - low; }
};

double round_to_dm(double meters) { return std::round(meters * 10) / 10; }

double area_of(const std::vector<std::size_t>& rooms, const std::vector<RoomRequest>& requests) {
  double area = 0;
  for (const std::size_t i : rooms) area += requests[i].area_m2;
  return area;
}

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

/// One row of rooms along x from `from` on.
void lay_row(const std::vector<std::size_t>& row, const std::vector<RoomRequest>& requests, double from, double length,
             double low, bool upwards, std::vector<Rect>& places) {
  const double depth = round_to_dm(area_of(row, requests) / length);
  double done = 0, left = from;
  for (const std::size_t i : row) {
    done += requests[i].area_m2;
    const double right = from + round_to_dm(length * done / area_of(row, requests));
    places[i] = upwards ? Rect{{left, low}, {right, low + depth}} : Rect{{left, low - depth}, {right, low}};
    left = right;
  }
}

/// The rooms but the first, which is the corridor, in a random order.
struct AlongACorridor {
  std::vector<std::size_t> living;  // kitchen, dining room and a living room, which are kept together
  std::vector<std::size_t> others;
};
std::optional<AlongACorridor> along_a_corridor(const std::vector<RoomRequest>& requests, Rng& rng) {
  if (requests.front().type != kCorridor) return std::nullopt;
  AlongACorridor rooms;
  bool living = false;
  for (std::size_t i = 1; i < requests.size(); ++i) {
    const std::string& type = requests[i].type;
    const bool first = type == "living_room" && !std::exchange(living, living || type == "living_room");
    (first || type == "kitchen" || type == "dining_room" ? rooms.living : rooms.others).push_back(i);
  }
  if (rooms.living.empty() || rooms.others.size() < 2) return std::nullopt;
  rng.shuffle(rooms.living);
  rng.shuffle(rooms.others);
  return rooms;
}

/// Each to the row that has less so far.
void share_out(const std::vector<std::size_t>& rooms, const std::vector<RoomRequest>& requests,
               std::vector<std::size_t>& upper, std::vector<std::size_t>& lower) {
  for (const std::size_t i : rooms) (area_of(upper, requests) <= area_of(lower, requests) ? upper : lower).push_back(i);
}

/// Often the lower row ends earlier.
double length_of_lower_row(double length, Rng& rng) {
  return rng.chance(0.5) ? length : round_to_dm(length * rng.uniform(0.75, 0.95));
}

double corridor_width(const std::vector<RoomRequest>& requests, double length) {
  return round_to_dm(std::clamp(requests.front().area_m2 / length, kCorridorSide_m, kWidestCorridor_m));
}

/// Two rows of rooms along a corridor as long as the longer of them.
std::optional<std::vector<Rect>> rows_plan(const std::vector<RoomRequest>& requests, Rng& rng) {
  auto rooms = along_a_corridor(requests, rng);
  if (!rooms) return std::nullopt;
  std::vector<std::size_t> upper = rooms->living, lower;
  share_out(rooms->others, requests, upper, lower);
  const auto living = static_cast<std::ptrdiff_t>(rooms->living.size());
  const auto before = static_cast<std::ptrdiff_t>(rng.below(upper.size() - rooms->living.size() + 1));
  std::rotate(upper.begin(), upper.begin() + living, upper.begin() + living + before);
  const double area = area_of(upper, requests) + area_of(lower, requests);
  const double length = round_to_dm(std::sqrt(area * rng.uniform(1.0, 1.8)));
  const double width = corridor_width(requests, length);
  std::vector<Rect> places(requests.size());
  places.front() = {{0, 0}, {length, width}};
  lay_row(upper, requests, 0, length, width, true, places);
  lay_row(lower, requests, 0, length_of_lower_row(length, rng), 0, false, places);
  return places;
}

/// Kitchen, dining and living room across the whole depth of the home, and from there a corridor between two rows.
std::optional<std::vector<Rect>> wing_plan(const std::vector<RoomRequest>& requests, Rng& rng) {
  auto rooms = along_a_corridor(requests, rng);
  if (!rooms) return std::nullopt;
  std::vector<std::size_t> upper, lower;
  share_out(rooms->others, requests, upper, lower);
  const double length =
      round_to_dm(std::sqrt((area_of(upper, requests) + area_of(lower, requests)) * rng.uniform(0.6, 1.4)));
  const double width = corridor_width(requests, length);
  std::vector<Rect> places(requests.size());
  lay_row(upper, requests, 0, length, width, true, places);
  lay_row(lower, requests, 0, length_of_lower_row(length, rng), 0, false, places);
  places.front() = {{0, 0}, {length, width}};
  const double low = places[lower.front()].low.y(), high = places[upper.front()].high.y();
  const double across = round_to_dm(area_of(rooms->living, requests) / (high - low));
  double done = 0, from = low;
  for (const std::size_t i : rooms->living) {
    done += requests[i].area_m2;
    const double to = low + round_to_dm((high - low) * done / area_of(rooms->living, requests));
    places[i] = {{-across, from}, {0, to}};
    from = to;
  }
  return places;
}

bool well_formed(const std::vector<Rect>& places, const std::vector<RoomRequest>& requests) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool corridor = requests[i].type == kCorridor;
    const double shorter = places[i].size().minCoeff(), longer = places[i].size().maxCoeff();
    if (shorter < (corridor ? kCorridorSide_m : kShortestSide_m)) return false;
    if (longer > (corridor ? kCorridorAspect : kLongestAspect) * shorter) return false;
  }
  return true;
}

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

std::optional<std::vector<Rect>> draw_places(const std::vector<RoomRequest>& requests, Rng& rng) {
  const double kind = rng.unit();
  const bool cut = requests.front().type != kCorridor || kind < kCut;
  auto places = cut                     ? cut_plan(requests, rng)
                : kind < kCut + kInRows ? rows_plan(requests, rng)
                                        : wing_plan(requests, rng);
  if (!places) return std::nullopt;
  const bool mirrored = rng.chance(0.5), turned = rng.chance(0.5);
  for (Rect& place : *places) {
    if (mirrored) std::tie(place.low.x(), place.high.x()) = std::pair(-place.high.x(), -place.low.x());
    if (turned) {
      std::swap(place.low.x(), place.low.y());
      std::swap(place.high.x(), place.high.y());
    }
  }
  return places;
}

}  // namespace

std::optional<FloorPlan> draw_floor_plan(const std::vector<RoomRequest>& requests, const RoomDoors& doors, Rng rng) {
  const auto rects = draw_places(requests, rng);
  if (!rects || !well_formed(*rects, requests)) return std::nullopt;
  std::vector<std::string> types;
  for (const RoomRequest& request : requests) types.push_back(request.type);
  const auto chosen = choose_openings(types, shared_walls(*rects), doors, rng);
  if (!chosen) return std::nullopt;
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
  for (const SharedWall& wall : *chosen) {
    const double from = rng.uniform(wall.from + kOpeningMargin_m, wall.to - kOpeningMargin_m - kOpeningWidth_m);
    plan.openings.push_back({"opening_" + std::to_string(plan.openings.size() + 1), plan.rooms[wall.a].id,
                             plan.rooms[wall.b].id, point_on(wall, from) - corner,
                             point_on(wall, from + kOpeningWidth_m) - corner, 2.0});
  }
  if (!entrance_of(plan.rooms)) return std::nullopt;
  return plan;
}

std::optional<Entrance> entrance_of(const std::vector<Room>& rooms) {
  constexpr double kLeast_m = kOpeningWidth_m + 0.4;
  std::optional<WallStretch> best;
  const Bounds bounds = room_bounds(rooms.front(), 1);
  const auto length = [&](const WallStretch& wall) { return bounds.high[wall.side % 2] - bounds.low[wall.side % 2]; };
  for (const WallStretch& wall : outer_walls(rooms, 0)) {
    if (wall.to - wall.from < kLeast_m) continue;
    if (!best || length(wall) < length(*best)) best = wall;
  }
  if (!best) return std::nullopt;
  const int along = best->side % 2, across = 1 - along;
  const bool low_side = best->side == 0 || best->side == 3;
  Entrance entrance;
  entrance.at[along] = (best->from + best->to) / 2;
  entrance.at[across] = low_side ? bounds.low[across] : bounds.high[across];
  entrance.inward[across] = low_side ? 1 : -1;
  return entrance;
}

std::vector<WallStretch> outer_walls(const std::vector<Room>& rooms, std::size_t room) {
  constexpr double kSame_m = 0.02;
  const Bounds own = room_bounds(rooms[room], 1);
  std::vector<WallStretch> outer;
  for (int side = 0; side < 4; ++side) {
    const int across = side % 2 == 0 ? 1 : 0, along = 1 - across;
    const bool low_side = side == 0 || side == 3;
    const double at = low_side ? own.low[across] : own.high[across];
    std::vector<std::pair<double, double>> behind;
    for (std::size_t i = 0; i < rooms.size(); ++i) {
      if (i == room) continue;
      const Bounds other = room_bounds(rooms[i], 1);
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
