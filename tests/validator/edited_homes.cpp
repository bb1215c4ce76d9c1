#include "tests/validator/edited_homes.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <string>
#include <utility>

namespace unietp::testing {
namespace {

using ::std::size_t;

constexpr std::array<const char*, 5> kRooms{"kitchen", "living_room", "bedroom", "bathroom", "bedroom"};
constexpr std::array<const char*, 24> kCategories{
    "Bed", "Sofa", "Fridge", "Shelf", "Dresser", "Desk", "Chair", "Stool", "SideTable", "Lamp", "Mug",    "Plate",
    "Cup", "Bowl", "Fork",   "Spoon", "Knife",   "Book", "Vase",  "Apple", "Potato",    "Box",  "Pillow", "Pan"};

/// Moves all points of the home, and turns its objects by an angle.
template <class Move>
Scene moved(Scene home, double angle, Move move) {
  const auto move_flat = [&move](Vec2& point) {
    const Vec3 to = move(Vec3(point.x(), point.y(), 0));
    point = {to.x(), to.y()};
  };
  for (Room& room : home.rooms) std::for_each(room.polygon.begin(), room.polygon.end(), move_flat);
  for (Opening& opening : home.openings) move_flat(opening.from), move_flat(opening.to);
  move_flat(home.agent.position);
  edit_nodes(home, [&](std::vector<Node>& nodes) {
    for (Node& node : nodes) {
      node.pose.position = move(node.pose.position);
      node.pose.rotation = Eigen::AngleAxisd(angle, Vec3::UnitZ()) * node.pose.rotation;
    }
  });
  return home;
}

Scene turned(Scene home, double angle) {
  const Eigen::AngleAxisd turn(angle, Vec3::UnitZ());
  return moved(std::move(home), angle, [&turn](const Vec3& p) -> Vec3 { return turn * p + Vec3(20, -3, 0); });
}

Scene one_object_moved(Scene home, Rng rng) {
  edit_nodes(home, [&rng](std::vector<Node>& nodes) {
    Node& node = nodes[rng.below(nodes.size())];
    node.pose.position += Vec3(rng.uniform(0.3, 1), rng.uniform(0.3, 1), 0);
  });
  return home;
}

Scene three_objects_removed(Scene home, Rng rng) {
  edit_nodes(home, [&rng](std::vector<Node>& nodes) {
    for (int i = 0; i < 3; ++i) nodes.erase(nodes.begin() + static_cast<std::ptrdiff_t>(rng.below(nodes.size())));
  });
  return home;
}

Scene one_room_removed(Scene home, Rng rng) {
  const size_t gone = rng.below(home.rooms.size());
  const Room room = home.rooms[gone];
  home.rooms.erase(home.rooms.begin() + static_cast<std::ptrdiff_t>(gone));
  edit_nodes(home, [&room](std::vector<Node>& nodes) {
    std::erase_if(nodes, [&room](const Node& node) { return contains(room.polygon, node.pose.position.head<2>()); });
  });
  return home;
}

/// Each category is called as the next one in the home's own list, for so large a share of the categories.
Scene renamed_categories(Scene home, Rng rng, double share) {
  std::vector<std::string> names;
  for (const Node& node : home.nodes) names.push_back(node.category);
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  std::vector<std::string> gone = names;
  rng.shuffle(gone);
  gone.resize(std::max<size_t>(1, static_cast<size_t>(share * static_cast<double>(gone.size()))));
  edit_nodes(home, [&](std::vector<Node>& nodes) {
    for (Node& node : nodes) {
      if (std::find(gone.begin(), gone.end(), node.category) == gone.end()) continue;
      const auto place = std::find(names.begin(), names.end(), node.category) - names.begin();
      node.category = names[(static_cast<size_t>(place) + 1) % names.size()];
    }
  });
  return home;
}

Scene one_category_renamed(Scene home, Rng rng) { return renamed_categories(std::move(home), rng, 0); }
Scene all_categories_renamed(Scene home, Rng rng) { return renamed_categories(std::move(home), rng, 1); }

Scene turned_a_quarter(Scene home, Rng rng) {
  return turned(std::move(home), static_cast<double>(1 + rng.below(3)) * std::numbers::pi / 2);
}
Scene turned_by_any_angle(Scene home, Rng rng) { return turned(std::move(home), rng.uniform(0, 6)); }

Scene all_moved_a_centimeter(Scene home, Rng rng) { return shaken(std::move(home), rng, 0.01); }

Scene half_of_the_rooms(Scene home, Rng) {
  const size_t half = home.rooms.size() / 2;
  return with_rooms(std::move(home), half);
}

Scene all_of_these(Scene home, Rng rng) {
  home = one_object_moved(std::move(home), rng.fork("moved", 0));
  home = three_objects_removed(std::move(home), rng.fork("removed", 0));
  home = one_category_renamed(std::move(home), rng.fork("renamed", 0));
  home = renumbered(mirrored(std::move(home), rng.fork("mirrored", 0)), rng.fork("numbers", 0));
  return one_room_removed(turned_by_any_angle(std::move(home), rng.fork("turned", 0)), rng.fork("room", 0));
}

}  // namespace

const std::vector<HomeEdit> kHomeEdits{
    {"one object moved", one_object_moved},
    {"mirrored", mirrored},
    {"turned by a quarter", turned_a_quarter},
    {"turned by any angle", turned_by_any_angle},
    {"renumbered", renumbered},
    {"three objects removed", three_objects_removed},
    {"one room removed", one_room_removed},
    {"one category renamed", one_category_renamed},
    {"all categories renamed", all_categories_renamed},
    {"all objects moved by 1 cm", all_moved_a_centimeter},
    {"half of the rooms only", half_of_the_rooms},
    {"moved, removed, renamed, mirrored, turned", all_of_these},
};

Scene drawn_home(std::uint64_t number) {
  Rng rng = Rng(5).fork("home", number);
  Scene home;
  home.id = "home-" + std::to_string(number);
  double x = 0;
  for (size_t i = 0; i < kRooms.size(); ++i) {
    const double width = rng.uniform(3, 6), depth = rng.uniform(3, 6);
    const auto id = std::string(kRooms[i]) + "_" + std::to_string(i);
    home.rooms.push_back({id, kRooms[i], {{x, 0}, {x + width, 0}, {x + width, depth}, {x, depth}}});
    for (int n = 0; n < 10; ++n) {
      const size_t category = rng.below(kCategories.size());
      Node node;
      node.category = kCategories[category];
      node.id = node.category + "_" + std::to_string(home.nodes.size());
      node.movable = category > 8;
      const double size = 2.0 / static_cast<double>(category + 1);
      node.size = {size * rng.uniform(0.7, 1), size * rng.uniform(0.7, 1), size * rng.uniform(0.7, 1)};
      node.pose.position = {x + rng.uniform(0.1, width - 0.1), rng.uniform(0.1, depth - 0.1), rng.uniform(0.1, 1)};
      home.nodes.push_back(node);
    }
    x += width;
  }
  return home;
}

Scene mirrored(Scene home, Rng) {
  home = moved(std::move(home), 0, [](const Vec3& p) { return Vec3(4 - p.x(), p.y(), p.z()); });
  for (Room& room : home.rooms) std::reverse(room.polygon.begin(), room.polygon.end());
  return home;
}

Scene renumbered(Scene home, Rng rng) {
  home.id += "-again";
  rng.shuffle(home.rooms);
  for (size_t i = 0; i < home.rooms.size(); ++i) home.rooms[i].id = "room_" + std::to_string(i);
  edit_nodes(home, [&rng](std::vector<Node>& nodes) {
    rng.shuffle(nodes);
    for (size_t i = 0; i < nodes.size(); ++i) nodes[i].id = "thing_" + std::to_string(i);
  });
  return home;
}

Scene shaken(Scene home, Rng rng, double most_m) {
  edit_nodes(home, [&rng, most_m](std::vector<Node>& nodes) {
    for (Node& node : nodes) node.pose.position += Vec3(rng.uniform(-most_m, most_m), rng.uniform(-most_m, most_m), 0);
  });
  return home;
}

Scene with_rooms(Scene home, size_t count) {
  home.rooms.resize(count);
  edit_nodes(home, [&home](std::vector<Node>& nodes) {
    std::erase_if(nodes, [&home](const Node& node) { return room_at(home, node.pose.position.head<2>()) == nullptr; });
  });
  return home;
}

Scene with_rooms_of(const Scene& home, size_t count, const Scene& other) {
  const double beside_m = 50;
  Scene mixed = with_rooms(home, count);
  for (size_t i = count; i < other.rooms.size(); ++i) {
    mixed.rooms.push_back(other.rooms[i]);
    for (Vec2& corner : mixed.rooms.back().polygon) corner.y() += beside_m;
    for (Node node : other.nodes) {
      if (!contains(other.rooms[i].polygon, node.pose.position.head<2>())) continue;
      node.pose.position.y() += beside_m;
      mixed.nodes.push_back(node);
    }
  }
  return mixed;
}

}  // namespace unietp::testing
