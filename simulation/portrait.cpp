#include "simulation/portrait.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "akb/default_states.h"

namespace unietp {

Portrait portrait_scene(const Node& object, const Profile& profile, const PortraitOptions& options) {
  constexpr double kRoom_m = 60, kTable_m = 0.75, kFov_deg = 36, kAround = 1.08;
  Scene scene;
  scene.simulator = profile.simulator;
  scene.wall_height = kRoom_m;
  scene.rooms = {{"room",
                  options.on_table ? "living_room" : "bedroom",
                  {{-kRoom_m, -kRoom_m}, {kRoom_m, -kRoom_m}, {kRoom_m, kRoom_m}, {-kRoom_m, kRoom_m}}}};
  Node shown = object;
  const double radius = shown.size.norm() / 2;
  if (options.on_table) {
    Node table;
    table.id = "table";
    table.archetype = Archetype::Block;
    table.size = Vec3(40 * radius, 40 * radius, kTable_m);
    table.pose.position.z() = kTable_m / 2;
    table.color = "beige";
    scene.nodes.push_back(table);
  }
  shown.pose = {Vec3(0, 0, (options.on_table ? kTable_m : 0) + shown.size.z() / 2), Quat::Identity()};
  scene.nodes.push_back(shown);
  Profile camera = profile;
  camera.image_width = camera.image_height = options.pixels;
  camera.vertical_fov_deg = kFov_deg;
  const double away = kAround * radius / std::sin(kFov_deg * std::numbers::pi / 360);
  const Vec2 aside(std::sin(options.turn_rad), -std::cos(options.turn_rad));
  scene.agent.position = away * std::cos(options.down_rad) * aside;
  scene.agent.yaw = std::atan2(-aside.y(), -aside.x());
  scene.agent.pitch = options.down_rad;
  camera.camera_height_m = shown.pose.position.z() + away * std::sin(options.down_rad);
  return {std::move(scene), camera};
}

Picture portrait_of(const Node& object, const Profile& profile, const PortraitOptions& options) {
  const Portrait portrait = portrait_scene(object, profile, options);
  Rays rays;
  return picture_of(portrait.scene, portrait.camera, rays);
}

Node object_of(const Knowledge& knowledge, const Category& category, std::uint32_t seed) {
  const auto usual = [seed](const std::vector<std::string>& names) {
    return names.empty() ? std::string() : names[seed % names.size()];
  };
  Node node;
  node.id = "object_" + std::to_string(seed + 1);
  node.category = category.name;
  node.movable = category.movable;
  node.archetype = category.archetype;
  node.size = category.size;
  node.mass = category.mass;
  node.color = usual(category.colors);
  node.material = usual(category.materials);
  node.openable = knowledge.has(category.name, "openable");
  set_default_states(node, knowledge);
  return node;
}

Picture sheet_of(const std::vector<Picture>& pictures, int columns) {
  const Picture& first = pictures.front();
  const int count = static_cast<int>(pictures.size()), rows = (count + columns - 1) / columns;
  Picture sheet{columns * first.width, rows * first.height, {}};
  const auto line = [](int pixels) { return 3 * static_cast<std::size_t>(pixels); };
  sheet.rgb.assign(line(sheet.width) * static_cast<std::size_t>(sheet.height), 255);
  for (int i = 0; i < count; ++i) {
    const Picture& one = pictures[static_cast<std::size_t>(i)];
    for (int y = 0; y < one.height; ++y) {
      const std::size_t to = line(sheet.width) * static_cast<std::size_t>(i / columns * first.height + y) +
                             line(i % columns * first.width);
      const auto from = one.rgb.begin() + static_cast<std::ptrdiff_t>(line(one.width) * static_cast<std::size_t>(y));
      std::copy(from, from + static_cast<std::ptrdiff_t>(line(one.width)),
                sheet.rgb.begin() + static_cast<std::ptrdiff_t>(to));
    }
  }
  return sheet;
}

}  // namespace unietp
