#include "run/category_weights.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "generator/domain_constraints.h"
#include "templates/init_shape.h"

namespace unietp {
namespace {

constexpr double kAdded = 1e-4;   // times the weight of what is there in the room that is used most
constexpr double kTooFew = 0.02;  // likewise, of what is there, but not in the number that is needed

constexpr double kOneOfRooms = 0.05;  // a type of room that the home has several of: "one of the bedrooms"

/// What furniture weighs of which the home has `more` than are needed. People name a place that the home has once or
/// tell which they mean; "a side table" of seven is what nobody says.
double weight_of_which(std::size_t more) {
  constexpr std::array kWeights{1.0, 0.3, 0.05};
  return more < kWeights.size() ? kWeights[more] : 0.02;
}

/// How many of each placeholder's category the start needs: those that `init` counts, and another one to tell it from.
std::vector<std::size_t> needed_by(const Template& source, Split split) {
  std::vector<std::size_t> needed;
  for (const auto& parameter : source.parameters) {
    int most = 1;
    for (const Formula& start : source.init) {
      if (start.domain == of_category(parameter.name)) most = std::max(most, demanded_count(start));
    }
    const bool distinguishable = split == Split::InstanceGrounding && source.split != split && needed.empty();
    needed.push_back(static_cast<std::size_t>(most + (distinguishable ? 1 : 0)));
  }
  return needed;
}

/// Of the types of room that the home has.
double least_room_weight(const Layout& layout, const Frequencies& counts) {
  const Scene& scene = layout.home.scene;
  const std::string prefix = std::string(name_of(scene.simulator)) + "/";
  double least = 1;
  for (const Room& room : scene.rooms) least = std::min(least, counts.weight(Dimension::Room, prefix + room.type));
  return least;
}

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

CategoryWeight weight_in(const Layout& layout, const Template& source, Split split, const Frequencies& counts,
                         const RoomTypes* rooms) {
  std::vector<Dimension> dimensions;
  for (const auto& parameter : source.parameters) dimensions.push_back(dimension_of(parameter, source));
  return [&layout, &source, &counts, rooms, dimensions = std::move(dimensions), needed = needed_by(source, split),
          least_room = rooms == nullptr ? 1.0 : least_room_weight(layout, counts),
          prefix = std::string(name_of(layout.home.scene.simulator)) + "/"](const Parameter& parameter,
                                                                            const std::string& category) {
    const auto at = static_cast<std::size_t>(&parameter - source.parameters.data());
    const auto dimension = dimensions[at];
    double own = counts.weight(dimension, prefix + category);
    if (is_value(parameter)) return own;
    if (dimension == Dimension::Category) own *= own;  // few things suit many templates, and these would be everywhere
    if (dimension == Dimension::Room) {
      const auto& all = layout.home.scene.rooms;
      const auto of_type = std::count_if(all.begin(), all.end(), [&](const Room& one) { return one.type == category; });
      return of_type > 1 ? own * kOneOfRooms : own;
    }
    const std::size_t there = layout.home.places.of(category).size();
    if (there == 0) return own * kAdded * least_room;
    if (there < needed[at]) {
      own *= kTooFew;
    } else if (!layout.home.scene.nodes[layout.home.places.of(category).front()].movable) {
      own *= weight_of_which(there - needed[at]);
    }
    if (rooms == nullptr) return own;
    const auto stands = rooms->find(category);
    if (stands == rooms->end()) return own;
    double room = 0;
    for (const auto& [type, share] : stands->second) room += share * counts.weight(Dimension::Room, type);
    return own * room;
  };
}

}  // namespace unietp
