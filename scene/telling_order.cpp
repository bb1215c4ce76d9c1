#include "scene/telling_order.h"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "core/rng.h"

namespace unietp {

TellingOrder telling_order(const Scene& scene) {
  const Rng names = Rng(0).fork(scene.id, 0);
  const auto drawn = [&](std::string_view id) { return names.fork(id, 0).next(); };
  TellingOrder order;
  std::vector<std::pair<std::uint64_t, std::size_t>> rooms;
  for (std::size_t i = 0; i < scene.rooms.size(); ++i) rooms.emplace_back(drawn(scene.rooms[i].id), i);
  std::sort(rooms.begin(), rooms.end());
  std::unordered_map<std::string_view, std::size_t> turn_of_room, turn_of_thing;  // never iterated
  for (const auto& [key, i] : rooms) {
    turn_of_room.emplace(scene.rooms[i].id, order.rooms.size());
    order.rooms.push_back(i);
  }
  const auto first = scene.edges.partition_point([](const Edge& edge) { return edge.relation < Predicate::InRoom; });
  for (auto edge = first; edge != scene.edges.end(); ++edge) {
    if (const auto room = turn_of_room.find((*edge).to); room != turn_of_room.end())
      turn_of_thing.emplace((*edge).from, room->second);
  }
  std::vector<std::tuple<std::size_t, std::uint64_t, std::size_t>> things;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const auto turn = turn_of_thing.find(scene.nodes[i].id);
    things.emplace_back(turn == turn_of_thing.end() ? order.rooms.size() : turn->second, drawn(scene.nodes[i].id), i);
  }
  std::sort(things.begin(), things.end());
  for (const auto& [turn, key, i] : things) order.nodes.push_back(i);
  return order;
}

Scene in_telling_order(const Scene& scene) {
  const TellingOrder order = telling_order(scene);
  Scene listed = scene;
  listed.rooms.clear();
  for (const std::size_t i : order.rooms) listed.rooms.push_back(scene.rooms[i]);
  listed.nodes.clear();
  for (const std::size_t i : order.nodes) listed.nodes.push_back(scene.nodes[i]);
  return listed;
}

}  // namespace unietp
