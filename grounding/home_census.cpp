#include "grounding/home_census.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "akb/metadata_json.h"

namespace unietp {
namespace {

constexpr double kCell_m = 0.1;
constexpr double kLow_m = 0.5, kFlat_m = 0.05;

struct Extent {
  Vec2 low, high;
};

Extent extent_of(const std::vector<Vec2>& outline) {
  Extent extent{outline.front(), outline.front()};
  for (const Vec2& corner : outline) {
    extent.low = extent.low.cwiseMin(corner);
    extent.high = extent.high.cwiseMax(corner);
  }
  return extent;
}

bool covers(const CensusObject& object, const Vec2& at) {
  if (!object.box || object.box->low.z() > kLow_m || object.box->high.z() - object.box->low.z() < kFlat_m) return false;
  return at.x() >= object.box->low.x() && at.x() <= object.box->high.x() && at.y() >= object.box->low.y() &&
         at.y() <= object.box->high.y();
}

}  // namespace

Result<StructureNames> read_structure_names(const std::filesystem::path& path) {
  const auto file = read_metadata_csv(path);
  if (!file) return file.error();
  StructureNames names;
  for (const auto& row : file->rows) names.insert(row.front().text);
  return names;
}

HomeCensus census_of(const Scene& scene, const StructureNames& structure) {
  HomeCensus home;
  for (const Room& room : scene.rooms) home.rooms.push_back({room.type, room.polygon, {}});
  std::map<std::string_view, const Node*> by_id;
  for (const Node& node : scene.nodes) by_id[node.id] = &node;
  std::map<std::string_view, std::vector<std::string>> held_by;
  for (const Edge& edge : scene.edges) {
    if (edge.relation != Predicate::On && edge.relation != Predicate::Inside) continue;
    if (const auto holder = by_id.find(edge.to); holder != by_id.end()) {
      held_by[edge.from].push_back(holder->second->category);
    }
  }
  for (const Node& node : scene.nodes) {
    if (structure.contains(node.category)) continue;
    const Room* room = room_at(scene, node.pose.position.head<2>());
    if (room == nullptr) continue;
    home.rooms[static_cast<std::size_t>(room - scene.rooms.data())].objects.push_back(
        {node.category, node.movable, bounds_of(node.pose, node.size), held_by[node.id]});
  }
  return home;
}

std::optional<double> free_floor_share(const CensusRoom& room) {
  if (room.outline.size() < 3) return std::nullopt;
  std::vector<const CensusObject*> low;
  for (const CensusObject& object : room.objects) {
    if (object.box && object.box->low.z() <= kLow_m) low.push_back(&object);
  }
  const Extent extent = extent_of(room.outline);
  const auto columns = static_cast<int>(std::ceil((extent.high.x() - extent.low.x()) / kCell_m));
  const auto rows = static_cast<int>(std::ceil((extent.high.y() - extent.low.y()) / kCell_m));
  int inside = 0, open = 0;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const Vec2 at = extent.low + Vec2((x + 0.5) * kCell_m, (y + 0.5) * kCell_m);
      if (!contains(room.outline, at)) continue;
      ++inside;
      if (std::none_of(low.begin(), low.end(), [&](const CensusObject* object) { return covers(*object, at); })) ++open;
    }
  }
  if (inside == 0) return std::nullopt;
  return static_cast<double>(open) / inside;
}

double floor_area(const CensusRoom& room) {
  double twice = 0;
  for (std::size_t i = 0; i < room.outline.size(); ++i) {
    const Vec2 a = room.outline[i], b = room.outline[(i + 1) % room.outline.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return std::abs(twice) / 2;
}

}  // namespace unietp
