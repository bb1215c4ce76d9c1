#include "environment/floor_plan.h"

#include <cmath>
#include <numbers>

#include "core/text.h"
#include "scene/geometry.h"
#include "scene/telling_order.h"

namespace unietp {
namespace {

double in_cm(double meters) {
  const double rounded = std::round(meters * 100) / 100;
  return rounded == 0 ? 0 : rounded;  // not -0
}
Vec2 in_cm(const Vec2& at) { return {in_cm(at.x()), in_cm(at.y())}; }
Vec3 in_cm(const Vec3& at) { return {in_cm(at.x()), in_cm(at.y()), in_cm(at.z())}; }

double in_degrees(double radians) {
  const double rounded = std::round(radians * 180 / std::numbers::pi);
  return rounded == 0 ? 0 : rounded;
}
/// From 0 to 359.
double turned(double radians) {
  const double degrees = std::fmod(in_degrees(radians), 360);
  return degrees < 0 ? degrees + 360 : degrees;
}

std::string point_text(const Vec2& at) { return "(" + number_text(at.x()) + ", " + number_text(at.y()) + ")"; }

}  // namespace

ToldFloorPlan floor_plan_of(const Scene& start, const ModeRules& rules) {
  ToldFloorPlan plan;
  const TellingOrder order = telling_order(start);
  if (rules.rooms) {
    for (const std::size_t place : order.rooms) {
      const Room& room = start.rooms[place];
      PlannedRoom& told = plan.rooms.emplace_back(PlannedRoom{room.id, {}});
      for (const Vec2& corner : room.polygon) told.outline.push_back(in_cm(corner));
    }
    for (const Opening& opening : start.openings)
      plan.doors.push_back({opening.room_a, opening.room_b, in_cm(opening.from), in_cm(opening.to)});
  }
  for (const std::size_t place : order.nodes) {
    const Node& node = start.nodes[place];
    if (node.movable || !rules.furniture) continue;
    plan.furniture.push_back({node.id, in_cm(node.pose.position), in_cm(node.size), turned(yaw_of(node.pose))});
  }
  return plan;
}

OwnPose own_pose(const Agent& agent) { return {in_cm(agent.position), turned(agent.yaw), in_degrees(agent.pitch)}; }

std::string floor_plan_text(const ToldFloorPlan& plan) {
  std::vector<std::string> rooms, doors, furniture;
  for (const PlannedRoom& room : plan.rooms) {
    std::string text = room.id;
    for (const Vec2& corner : room.outline) text += " " + point_text(corner);
    rooms.push_back(std::move(text));
  }
  for (const PlannedDoor& door : plan.doors)
    doors.push_back(door.room_a + " and " + door.room_b + " " + point_text(door.from) + " " + point_text(door.to));
  for (const PlannedFurniture& one : plan.furniture) {
    furniture.push_back(one.id + " (" + number_text(one.middle.x()) + ", " + number_text(one.middle.y()) + ", " +
                        number_text(one.middle.z()) + ") " + number_text(one.size.x()) + " x " +
                        number_text(one.size.y()) + " x " + number_text(one.size.z()) + ", " +
                        number_text(one.turned_deg));
  }
  std::string text;
  const auto add = [&](const char* title, const std::vector<std::string>& lines) {
    if (!lines.empty()) text += title + join(lines, "; ") + ".\n";
  };
  add("Rooms by their corners, in meters: ", rooms);
  add("Doorways by their ends: ", doors);
  add("Furniture by its middle, size and the degrees by which it is turned counterclockwise: ", furniture);
  return text;
}

std::string pose_text(const OwnPose& pose) {
  std::string text =
      "You stand at " + point_text(pose.position) + ", facing " + number_text(pose.facing_deg) + " degrees";
  if (pose.down_deg > 0) text += ", looking " + number_text(pose.down_deg) + " degrees down";
  if (pose.down_deg < 0) text += ", looking " + number_text(-pose.down_deg) + " degrees up";
  return text + ".";
}

}  // namespace unietp
