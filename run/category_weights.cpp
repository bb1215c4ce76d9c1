#include "run/category_weights.h"

#include <string_view>
#include <utility>
#include <vector>

#include "generator/domain_constraints.h"

namespace unietp {
namespace {

constexpr double kAdded = 1e-4;  // times the weight of what is there

}  // namespace

RoomTypes room_types_in(const Layout& layout) {
  RoomTypes types;
  const auto& scene = layout.home.scene;
  const std::string prefix = std::string(name_of(scene.simulator)) + "/";
  std::map<std::string_view, int> in_rooms;  // nodes of a category
  for (std::size_t node = 0; node < scene.nodes.size(); ++node) {
    const auto room = layout.home.rooms[node];
    if (room < 0) continue;
    const auto& category = scene.nodes[node].category;
    ++in_rooms[category];
    types[category][prefix + scene.rooms[static_cast<std::size_t>(room)].type] += 1;
  }
  for (auto& [category, shares] : types) {
    for (auto& [type, share] : shares) share /= in_rooms[category];
  }
  return types;
}

CategoryWeight weight_in(const Layout& layout, const Template& source, const Frequencies& counts,
                         const RoomTypes* rooms) {
  std::vector<Dimension> dimensions;
  for (const auto& parameter : source.parameters) dimensions.push_back(dimension_of(parameter, source));
  return [&layout, &source, &counts, rooms, dimensions = std::move(dimensions),
          prefix = std::string(name_of(layout.home.scene.simulator)) + "/"](const Parameter& parameter,
                                                                            const std::string& category) {
    const auto dimension = dimensions[static_cast<std::size_t>(&parameter - source.parameters.data())];
    const double own = counts.weight(dimension, prefix + category);
    if (dimension == Dimension::Room || is_value(parameter)) return own;
    if (layout.home.places.of(category).empty()) return own * kAdded;
    if (rooms == nullptr) return own;
    const auto stands = rooms->find(category);
    if (stands == rooms->end()) return own;
    double room = 0;
    for (const auto& [type, share] : stands->second) room += share * counts.weight(Dimension::Room, type);
    return own * room;
  };
}

}  // namespace unietp
