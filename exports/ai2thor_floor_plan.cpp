#include "exports/ai2thor_floor_plan.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "interchange/house_json.h"
#include "interchange/own_ids.h"
#include "interchange/unity.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

bool is_of_floor_plan(const Node& node) { return own_id_of(node, Simulator::Ai2thor).has_value(); }

}  // namespace

bool is_floor_plan(const FinishedTask& task) {
  const auto& nodes = task.start.nodes;
  return task.record.layout.starts_with("FloorPlan") && std::any_of(nodes.begin(), nodes.end(), is_of_floor_plan);
}

ExportedScene write_floor_plan(const FinishedTask& task) {
  const Scene& start = task.start;
  const std::string& name = task.record.layout;
  ExportedScene written;
  for (const Node& node : start.nodes) {
    if (const auto id = own_id_of(node, Simulator::Ai2thor)) {
      written.names[node.id] = *id;
    } else {
      written.left_out.push_back(node.id + ": " + name + " has no such object");
    }
  }
  Json rooms = Json::array();
  const std::vector<std::string> ids = procthor_room_ids(start);
  for (std::size_t i = 0; i < start.rooms.size(); ++i) {
    Json floor = Json::array();
    for (const Vec2& corner : start.rooms[i].polygon) floor.push_back(house_point(corner));
    rooms.push_back({{"id", ids[i]}, {"floorPolygon", std::move(floor)}});
  }
  const Json plan{{"scene", name}, {"rooms", std::move(rooms)}, {"metadata", house_metadata(start)}};
  written.text = plan.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
  return written;
}

Json floor_plan_poses(const Scene& start) {
  Json poses = Json::array();
  for (const Node& node : start.nodes) {
    if (!node.movable || !is_of_floor_plan(node)) continue;
    poses.push_back({{"objectId", *own_id_of(node, Simulator::Ai2thor)},
                     {"center", house_xyz(to_unity(node.pose.position))},
                     {"rotation", house_xyz(rotation_to_unity(node.pose.rotation), 1000)}});
  }
  return {{"action", "SetObjectPoses"}, {"objectPoses", std::move(poses)}};
}

}  // namespace unietp
