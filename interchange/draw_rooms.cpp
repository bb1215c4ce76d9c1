#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "core/limits.h"
#include "core/text.h"
#include "interchange/category_names.h"
#include "interchange/draft.h"
#include "interchange/own_ids.h"

namespace unietp {
namespace {

constexpr double kMargin_m = 0.1;  // between what stands in a drawn room and the middle of its walls
constexpr double kDoor_m = 0.9;    // width of an opening that is made
constexpr double kDoorHeight_m = 2.0;
constexpr double kSameDrawnWall_m = 0.35;  // edges of two rooms that are nearer are two sides of one wall

struct Rectangle {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity()), high = -low;
  void add(const Bounds& bounds) {
    low = low.cwiseMin(bounds.low.head<2>());
    high = high.cwiseMax(bounds.high.head<2>());
  }
  void add(const Rectangle& other) {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }
  bool overlaps(const Rectangle& other) const {
    return ((high.cwiseMin(other.high) - low.cwiseMax(other.low)).array() > 0).all();
  }
  std::vector<Vec2> outline() const { return {low, {high.x(), low.y()}, high, {low.x(), high.y()}}; }
};

double area_of(const std::vector<Vec2>& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

bool usable(const SourceObject& object) {
  return object.pose.position.allFinite() && object.size.allFinite() && object.pose.rotation.coeffs().allFinite() &&
         object.pose.position.cwiseAbs().maxCoeff() < 1000 && object.size.maxCoeff() < 50;
}

/// One rectangle for each name of a room that objects stand in; rectangles that overlap become one. Without names, one
/// around everything.
std::vector<Room> rooms_around(const SourceScene& source) {
  std::map<std::string, Rectangle> named;
  Rectangle all;
  for (const SourceObject& object : source.objects) {
    if (!usable(object)) continue;
    const Bounds bounds = bounds_of(object.pose, object.size);
    all.add(bounds);
    if (!object.room.empty()) named[object.room].add(bounds);
  }
  if (all.low.x() > all.high.x()) return {};
  if (named.empty() || named.size() > limits::kNamedRooms) named = {{"room", all}};
  for (bool merged = true; merged;) {
    merged = false;
    for (auto a = named.begin(); a != named.end() && !merged; ++a) {
      for (auto b = std::next(a); b != named.end() && !merged; ++b) {
        if (!a->second.overlaps(b->second)) continue;
        a->second.add(b->second);
        named.erase(b);
        merged = true;
      }
    }
  }
  std::vector<Room> rooms;
  for (auto& [name, rectangle] : named) {
    rectangle.low -= Vec2::Constant(kMargin_m);
    rectangle.high += Vec2::Constant(kMargin_m);
    rooms.push_back({name, lower(name), rectangle.outline()});
  }
  return rooms;
}

struct Edge2 {
  Vec2 start, along;  // `along` is a unit vector
  double length = 0;
};

std::vector<Edge2> edges_of(const Room& room) {
  std::vector<Edge2> edges;
  for (std::size_t i = 0; i < room.polygon.size(); ++i) {
    const Vec2 start = room.polygon[i], whole = room.polygon[(i + 1) % room.polygon.size()] - start;
    const double length = whole.norm();
    if (length > kDoor_m) edges.push_back({start, whole / length, length});
  }
  return edges;
}

/// Where two rooms share a wall long enough for a door: the gap on the one's edge and on the other's.
struct SharedWall {
  Vec2 from_a, to_a, from_b, to_b;
  double length = 0;
};

std::optional<SharedWall> shared_wall(const Room& a, const Room& b) {
  std::optional<SharedWall> best;
  for (const Edge2& one : edges_of(a)) {
    const Vec2 across(-one.along.y(), one.along.x());
    for (const Edge2& two : edges_of(b)) {
      if (std::abs(one.along.dot(two.along)) < 0.999) continue;
      const double gap = (two.start - one.start).dot(across);
      if (std::abs(gap) > kSameDrawnWall_m) continue;
      double from = (two.start - one.start).dot(one.along), to = from + two.length * one.along.dot(two.along);
      if (from > to) std::swap(from, to);
      from = std::max(from, 0.0);
      to = std::min(to, one.length);
      if (to - from < kDoor_m || (best && best->length >= to - from)) continue;
      const double middle = (from + to) / 2;
      const Vec2 start = one.start + (middle - kDoor_m / 2) * one.along, end = start + kDoor_m * one.along;
      best = SharedWall{start, end, start + gap * across, end + gap * across, to - from};
    }
  }
  return best;
}

/// Doors for rooms that have none: a tree over the rooms, longest shared walls first.
void make_openings(Scene& scene) {
  struct Candidate {
    std::size_t a, b;
    SharedWall wall;
  };
  std::vector<Candidate> candidates;
  for (std::size_t a = 0; a < scene.rooms.size(); ++a) {
    for (std::size_t b = a + 1; b < scene.rooms.size(); ++b) {
      if (const auto wall = shared_wall(scene.rooms[a], scene.rooms[b])) candidates.push_back({a, b, *wall});
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& x, const Candidate& y) { return x.wall.length > y.wall.length; });
  std::vector<std::size_t> group(scene.rooms.size());
  std::iota(group.begin(), group.end(), 0);
  for (const Candidate& c : candidates) {
    if (group[c.a] == group[c.b]) continue;
    const std::size_t joined = group[c.b];
    std::replace(group.begin(), group.end(), joined, group[c.a]);
    const std::string id = "opening_" + std::to_string(scene.openings.size() + 1);
    const std::string &a = scene.rooms[c.a].id, &b = scene.rooms[c.b].id;
    scene.openings.push_back({id, a, b, c.wall.from_a, c.wall.to_a, kDoorHeight_m});
    if ((c.wall.from_a - c.wall.from_b).norm() < 0.01) continue;
    scene.openings.push_back({id + "_far_side", a, b, c.wall.from_b, c.wall.to_b, kDoorHeight_m});
  }
}

/// "kitchen_1" for each room that the file numbers, counted by type.
std::map<std::string, std::string> our_ids(const SourceScene& source) {
  std::map<std::string, std::string> ours;
  std::map<std::string, int> count;
  for (const Room& room : source.rooms) {
    const std::string id = room.type + "_" + std::to_string(++count[room.type]);
    if (own_id_of(room, source.simulator)) ours.emplace(room.id, id);
  }
  return ours;
}

}  // namespace

void draw_rooms(const SourceScene& source, Scene& scene, bool own_ids) {
  scene.wall_height = std::clamp(source.wall_height, 1.0, 20.0);
  scene.wall_thickness = std::clamp(source.wall_thickness, 0.005, 1.0);
  const auto ours = own_ids ? std::map<std::string, std::string>() : our_ids(source);
  const auto name_of_room = [&](const std::string& id) {
    const auto found = ours.find(id);
    return found == ours.end() ? id : found->second;
  };
  std::set<std::string> ids{"agent"};
  for (Room room : source.rooms.empty() ? rooms_around(source) : source.rooms) {
    room.id = name_of_room(room.id);
    if (area_of(room.polygon) < 0) std::reverse(room.polygon.begin(), room.polygon.end());
    if (room.polygon.size() >= 3 && ids.insert(room.id).second) scene.rooms.push_back(std::move(room));
  }
  for (Opening opening : source.openings) {
    opening.room_a = name_of_room(opening.room_a), opening.room_b = name_of_room(opening.room_b);
    const bool known = find_room(scene, opening.room_a) != nullptr && find_room(scene, opening.room_b) != nullptr;
    if (known && ids.insert(opening.id).second) scene.openings.push_back(std::move(opening));
  }
  if (source.openings.empty()) make_openings(scene);
}

}  // namespace unietp
