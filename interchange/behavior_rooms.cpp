#include "interchange/behavior_rooms.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <string>
#include <utility>

#include "core/limits.h"
#include "interchange/floor_tiles.h"

namespace unietp {
namespace {

constexpr double kBeside_m = 0.5, kFarBeside_m = 2;
constexpr double kSameWall_m = 0.3;  // floors of neighbors end on the two sides of a wall

struct Floor {
  std::string room;
  std::vector<Tile> tiles, holes;
  double area() const {
    const Tile around = bounds_of(tiles);
    return (around.high - around.low).prod();
  }
};

/// "private_office_0" → "private_office"
std::string type_of(std::string room) {
  const auto end = room.rfind('_');
  const bool numbered = end != std::string::npos && end + 1 < room.size() &&
                        std::all_of(room.begin() + static_cast<std::ptrdiff_t>(end) + 1, room.end(),
                                    [](unsigned char c) { return std::isdigit(c); });
  return numbered ? room.substr(0, end) : room;
}

bool overlap(const Tile& a, const Tile& b) { return (a.high.cwiseMin(b.high) - a.low.cwiseMax(b.low)).minCoeff() > 0; }

/// A floor's file gives its root link and not its middle, so that the box can lie off by a meter: what the file says to
/// stand in the room, and stands a little beside it, shows how far the nearest tile reaches.
void reach_out(std::vector<Tile>& tiles, const Vec3& position) {
  const Vec2 point = position.head<2>();
  if (!point.allFinite()) return;
  const auto beside = [&](const Tile& tile) {
    return (tile.low - point).cwiseMax(point - tile.high).cwiseMax(Vec2::Zero()).norm();
  };
  Tile& nearest = *std::min_element(tiles.begin(), tiles.end(),
                                    [&](const Tile& a, const Tile& b) { return beside(a) < beside(b); });
  const double distance = beside(nearest);
  if (distance < kBeside_m || distance > kFarBeside_m) return;
  nearest.low = nearest.low.cwiseMin(point);
  nearest.high = nearest.high.cwiseMax(point);
}

std::vector<Floor> floors_of(const SourceScene& scene) {
  std::map<std::string, std::vector<Tile>> tiles;
  for (const SourceObject& object : scene.objects) {
    if (object.category != "floors" || object.room.empty() || object.size.isZero()) continue;
    const Bounds bounds = bounds_of(object.pose, object.size);
    if (!bounds.low.allFinite() || !bounds.high.allFinite() || bounds.high.x() - bounds.low.x() > 200) continue;
    tiles[object.room].push_back({bounds.low.head<2>(), bounds.high.head<2>()});
  }
  for (const SourceObject& object : scene.objects) {
    if (const auto own = tiles.find(object.room); own != tiles.end()) reach_out(own->second, object.pose.position);
  }
  std::vector<Floor> floors;
  for (auto& [room, list] : tiles) floors.push_back({room, std::move(list), {}});
  return floors;
}

}  // namespace

void add_floor_rooms(SourceScene& scene) {
  std::vector<Floor> floors = floors_of(scene);
  if (floors.empty() || floors.size() > limits::kNamedRooms) return;
  std::vector<Tile*> all;
  for (Floor& floor : floors) {
    for (Tile& tile : floor.tiles) all.push_back(&tile);
  }
  align(all, kSameWall_m);
  std::stable_sort(floors.begin(), floors.end(), [](const Floor& a, const Floor& b) { return a.area() > b.area(); });
  std::map<std::string, std::string> part_of;
  std::vector<Floor> kept;
  for (Floor& floor : floors) {
    if (!outline_of(floor.tiles)) floor.tiles = {bounds_of(floor.tiles)};
    std::vector<Floor> smaller = kept;
    std::string around;
    for (Floor& larger : smaller) {
      for (const Tile& tile : floor.tiles) {
        const bool meets = std::any_of(larger.tiles.begin(), larger.tiles.end(),
                                       [&](const Tile& other) { return overlap(tile, other); });
        if (meets) larger.holes.push_back(tile);
      }
      if (around.empty() && !outline_of(larger.tiles, larger.holes)) around = larger.room;
    }
    if (around.empty() && (floor.tiles.front().high - floor.tiles.front().low).minCoeff() > 0) {
      kept = std::move(smaller);
      kept.push_back(std::move(floor));
    } else {
      part_of[floor.room] = around.empty() && !kept.empty() ? kept.front().room : around;
      scene.warnings.push_back(floor.room + ": inside another room, taken as a part of it");
    }
  }
  std::sort(kept.begin(), kept.end(), [](const Floor& a, const Floor& b) { return a.room < b.room; });
  for (const Floor& floor : kept) {
    const auto outline = outline_of(floor.tiles, floor.holes);
    if (outline) scene.rooms.push_back({floor.room, type_of(floor.room), *outline});
  }
  for (SourceObject& object : scene.objects) {
    if (const auto larger = part_of.find(object.room); larger != part_of.end()) object.room = larger->second;
  }
}

}  // namespace unietp
