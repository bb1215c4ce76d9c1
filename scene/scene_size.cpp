#include "scene/scene_size.h"

#include "core/in_quotes.h"
#include "core/limits.h"
#include "core/text.h"

namespace unietp {
namespace {

std::string larger(std::string_view what, double value, double most, std::string_view unit) {
  return std::string(what) + " " + number_text(value) + " " + std::string(unit) + "; accepted are at most " +
         number_text(most) + " " + std::string(unit);
}

}  // namespace

std::string excess_of(const Scene& scene) {
  if (!(scene.wall_height <= limits::kWallHeight_m))
    return larger("the walls have a height of", scene.wall_height, limits::kWallHeight_m, "m");
  if (!(scene.wall_thickness <= limits::kWallThickness_m))
    return larger("the walls have a thickness of", scene.wall_thickness, limits::kWallThickness_m, "m");
  for (const Opening& opening : scene.openings) {
    if (!(opening.height <= limits::kWallHeight_m))
      return larger("the opening " + in_quotes(opening.id) + " has a height of", opening.height, limits::kWallHeight_m,
                    "m");
  }
  if (scene.rooms.empty()) return "";
  Bounds all = room_bounds(scene.rooms.front(), 0);
  double area = 0;
  for (const Room& room : scene.rooms) {
    if (room.polygon.size() > limits::kRoomCorners)
      return "the room " + in_quotes(room.id) + " has " + std::to_string(room.polygon.size()) +
             " corners; accepted are at most " + std::to_string(limits::kRoomCorners);
    for (const Vec2& corner : room.polygon) {
      if (!corner.allFinite()) return "the room " + in_quotes(room.id) + " has a corner that is not finite";
    }
    const Bounds own = room_bounds(room, 0);
    all = {all.low.cwiseMin(own.low), all.high.cwiseMax(own.high)};
    area += (own.high - own.low).head<2>().prod();
  }
  const double width = (all.high - all.low).maxCoeff();
  if (!(width <= limits::kHomeWidth_m)) return larger("the rooms extend over", width, limits::kHomeWidth_m, "m");
  if (!(area <= limits::kRoomsArea_m2))
    return larger("the boxes around the rooms have an area of", area, limits::kRoomsArea_m2, "m2");
  return "";
}

}  // namespace unietp
