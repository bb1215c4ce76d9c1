#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"
#include "simulation/mode_rules.h"

namespace unietp {

/// A room on a floor plan: the corners of its floor, one after the other.
struct PlannedRoom {
  std::string id;
  std::vector<Vec2> outline;  // meters
  bool operator==(const PlannedRoom&) const = default;
};

/// A doorway: the two ends of a gap in the wall between two rooms.
struct PlannedDoor {
  std::string room_a, room_b;
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();  // meters
  bool operator==(const PlannedDoor&) const = default;
};

/// Furniture on a floor plan: its box, which is turned about its middle.
struct PlannedFurniture {
  std::string id;
  Vec3 middle = Vec3::Zero(), size = Vec3::Zero();  // meters; the front is the side of -y before it is turned
  double turned_deg = 0;                            // counterclockwise from above
  bool operator==(const PlannedFurniture&) const = default;
};

/// What a robot's map of a home shows: rooms, doorways, and which furniture stands where. Not how anything looks, and
/// nothing that can be moved. Rounded to centimeters and degrees.
struct ToldFloorPlan {
  std::vector<PlannedRoom> rooms;
  std::vector<PlannedDoor> doors;
  std::vector<PlannedFurniture> furniture;
  bool operator==(const ToldFloorPlan&) const = default;
};

/// Where an agent stands and looks, as it knows itself.
struct OwnPose {
  Vec2 position = Vec2::Zero();         // meters
  double facing_deg = 0, down_deg = 0;  // counterclockwise from +x; below level
  bool operator==(const OwnPose&) const = default;
};

/// Of the home of `start`, as far as the rules tell of rooms and furniture, in the order of telling_order.
ToldFloorPlan floor_plan_of(const Scene& start, const ModeRules& rules);
OwnPose own_pose(const Agent& agent);

/// A line each, as "Doorways by their ends: …", for rooms, doorways and furniture; "" when it shows nothing.
std::string floor_plan_text(const ToldFloorPlan& plan);
/// "You stand at (1.5, 2.3), facing 90 degrees, looking 15 degrees down."
std::string pose_text(const OwnPose& pose);

}  // namespace unietp
