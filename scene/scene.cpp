#include "scene/scene.h"

#include <algorithm>
#include <tuple>

namespace unietp {
const Node* find_node(const Scene& scene, std::string_view id) {
  const auto found = std::find_if(scene.nodes.begin(), scene.nodes.end(), [id](const Node& n) { return n.id == id; });
  return found == scene.nodes.end() ? nullptr : &*found;
}

Node* edit_node(Scene& scene, std::string_view id) {
  const auto found = std::find_if(scene.nodes.begin(), scene.nodes.end(), [id](const Node& n) { return n.id == id; });
  return found == scene.nodes.end() ? nullptr
                                    : &scene.nodes.edit(static_cast<std::size_t>(found - scene.nodes.begin()));
}

const Room* find_room(const Scene& scene, std::string_view id) {
  const auto found = std::find_if(scene.rooms.begin(), scene.rooms.end(), [id](const Room& r) { return r.id == id; });
  return found == scene.rooms.end() ? nullptr : &*found;
}

bool has_edge(const Scene& scene, Predicate relation, std::string_view from, std::string_view to) {
  using Key = std::tuple<Predicate, std::string_view, std::string_view>;
  const Key wanted{relation, from, to};
  const auto key_of = [](const Edge& edge) { return Key{edge.relation, edge.from, edge.to}; };
  const auto place = scene.edges.partition_point([&](const Edge& edge) { return key_of(edge) < wanted; });
  return place != scene.edges.end() && key_of(*place) == wanted;
}

Bounds room_bounds(const Room& room, double height) {
  if (room.polygon.empty()) return {};
  Vec2 low = room.polygon.front(), high = low;
  for (const Vec2& corner : room.polygon) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  return {{low.x(), low.y(), 0}, {high.x(), high.y(), height}};
}

const Room* room_at(const Scene& scene, const Vec2& point) {
  const auto found = std::find_if(scene.rooms.begin(), scene.rooms.end(),
                                  [&](const Room& room) { return contains(room.polygon, point); });
  return found == scene.rooms.end() ? nullptr : &*found;
}

}  // namespace unietp
