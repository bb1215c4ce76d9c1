#include "simulation/plug_solids.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace unietp {
namespace {

constexpr double kReach_m = 0.2;  // how far a wall may be behind a thing whose plug is in it

/// A place on a wall for a socket.
struct WallSocket {
  Pose pose;  // on the surface: x along the wall to the right, y into it, z up
  Vec3 from;  // where the cord leaves the thing, in this frame
};

class Boxes {
 public:
  Boxes(const Pose& frame, std::int32_t owner, std::vector<Solid>& solids)
      : frame_(frame), owner_(owner), solids_(solids) {}

  void add(const Vec3& center, const Vec3& size, Skin skin) {
    solids_.push_back({SolidKind::Box, frame_ * Pose{center, Quat::Identity()}, size, owner_, false, skin});
  }
  /// From `low` to `high`, in any order.
  void between(const Vec3& low, const Vec3& high, Skin skin) { add((low + high) / 2, (high - low).cwiseAbs(), skin); }

 private:
  Pose frame_;
  std::int32_t owner_;
  std::vector<Solid>& solids_;
};

/// Half the room that a thing takes up along a direction.
double extent_along(const Node& node, const Vec3& direction) {
  return (node.pose.rotation.conjugate() * direction).cwiseAbs().dot(node.size / 2);
}

/// Whether it stands on the floor.
bool on_floor(const Node& node) {
  constexpr double kOn_m = 0.05;
  return node.pose.position.z() - extent_along(node, Vec3::UnitZ()) < kOn_m;
}

/// Where a socket is, and the cord's end at the thing, by height above the floor.
struct Heights {
  double socket = 0, cord = 0;
  bool above = false;  // the thing, not beside it
};

/// Above the cups on the table or counter that the thing stands on. What stands on the floor has its socket above the
/// counters beside it: over it, if it is as low as they are.
Heights heights_of(const Node& node, double plate) {
  constexpr double kAboveTable_m = 0.2, kAboveCounters_m = 1.2, kDrop_m = 0.15;
  const double reach = extent_along(node, Vec3::UnitZ()), low = node.pose.position.z() - reach, top = low + 2 * reach;
  if (!on_floor(node)) return {low + kAboveTable_m, low};
  if (top < kAboveCounters_m - plate / 2) return {kAboveCounters_m, top, true};
  return {kAboveCounters_m, std::min(top, kAboveCounters_m) - kDrop_m};
}

/// On the nearest wall within reach, at the right of the thing or, where the wall does not go on there, at its left.
std::optional<WallSocket> wall_socket(const Node& node, double plate, std::span<const WallPiece> walls) {
  constexpr double kBeside_m = 0.05, kInWall_m = 0.02;
  const Heights heights = heights_of(node, plate);
  std::optional<WallSocket> found;
  double nearest = kReach_m;
  for (const WallPiece& wall : walls) {
    const Quat& turn = wall.pose.rotation;
    const Vec3 at = turn.conjugate() * (node.pose.position - wall.pose.position), half = wall.size / 2;
    const double side = at.y() > 0 ? 1 : -1;  // of the wall on which the thing is
    const double deep = extent_along(node, turn * Vec3::UnitY()), wide = extent_along(node, turn * Vec3::UnitX());
    const double away = side * at.y() - half.y() - deep, z = heights.socket - wall.pose.position.z();
    if (away < -kInWall_m || away >= nearest || std::abs(z) > half.z() - plate) continue;
    for (const double right : {-side, side}) {
      const double x = at.x() + right * (heights.above ? wide / 2 : wide + kBeside_m + plate / 2);
      if (std::abs(x) > half.x() - plate) continue;
      const Quat faces = side < 0 ? turn : turn * Quat(Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitZ()));
      const Pose socket{wall.pose * Vec3(x, side * half.y(), z), faces};
      const Vec3 end(heights.above ? x : at.x() + right * wide, at.y() - side * deep,
                     z + heights.cord - heights.socket);
      found = WallSocket{socket, inverse(socket) * (wall.pose * end)};
      nearest = away;
      break;
    }
  }
  return found;
}

void add_in_wall(const WallSocket& socket, double plate, Boxes& boxes) {
  const double plug = 0.4 * plate, cord = 0.1 * plate, deep = 0.24 * plate;
  constexpr double kThin_m = 0.008;
  boxes.add({0, -kThin_m - deep / 2, 0}, {plug, deep, plug}, Skin::Plug);
  boxes.add({0, -kThin_m / 2, 0}, {plate, kThin_m, plate}, Skin::Socket);
  // From the plug down along the wall, along it to the thing, and away from it.
  const double y = -kThin_m - cord, z = socket.from.z() + cord / 2;
  const Vec3 thick = Vec3::Constant(cord / 2), corner(0, y, z), beside(socket.from.x(), y, z);
  const auto run = [&](const Vec3& a, const Vec3& b) {
    boxes.between(a.cwiseMin(b) - thick, a.cwiseMax(b) + thick, Skin::Cord);
  };
  run(corner, {0, y, 0});
  run(corner, beside);
  if (socket.from.y() < y) run({beside.x(), socket.from.y(), z}, beside);
}

/// Along the right side of the thing, from its back: a cord, and a plug in the socket of an extension cord, or alone.
void add_beside(const Node& node, bool in, double plug, Boxes& boxes) {
  const Vec3 half = node.size / 2;
  const double cord = 0.3 * plug, x = half.x() + plug / 2, z = -half.z() + plug / 2;
  const double length = 1.4 * plug, prongs = 0.7 * plug, front = -half.y();
  const double block = std::clamp(node.size.y() - 1.6 * length, 1.5 * plug, 3 * plug);
  const double end = front + (in ? block : prongs);  // of the plug, to the front
  boxes.between({x - cord / 2, end + length, z - cord / 2},
                {x + cord / 2, std::max(half.y(), end + 1.2 * length), z + cord / 2}, Skin::Cord);
  boxes.add({x, end + length / 2, z}, {plug, length, plug}, Skin::Plug);
  if (in) {
    boxes.add({x, end - block / 2, z}, {0.9 * plug, block, 0.9 * plug}, Skin::Socket);
    return;
  }
  for (const double side : {-0.25 * plug, 0.25 * plug})
    boxes.add({x + side, end - prongs / 2, z}, {0.18 * plug, prongs, 0.3 * plug}, Skin::Socket);
}

/// On the floor before the thing, at its right.
void add_before(const Node& node, double plug, Boxes& boxes) {
  const Vec3 half = node.size / 2;
  const double cord = 0.3 * plug, y = -half.y() - 1.5 * plug, z = -half.z() + plug / 2, x = half.x() - plug / 2;
  boxes.between({x - cord / 2, -half.y(), z - cord / 2}, {x + cord / 2, y - cord / 2, z + cord / 2}, Skin::Cord);
  boxes.between({x - plug, y - cord / 2, z - cord / 2}, {x + cord / 2, y + cord / 2, z + cord / 2}, Skin::Cord);
  boxes.add({x - 1.5 * plug, y, z}, {plug, 1.2 * plug, plug}, Skin::Plug);
  for (const double side : {-0.35 * plug, 0.35 * plug})
    boxes.add({x - 2.4 * plug, y + side, z}, {0.8 * plug, 0.2 * plug, 0.2 * plug}, Skin::Socket);
}

}  // namespace

void add_plug_solids(const Node& node, std::int32_t owner, std::span<const WallPiece> walls,
                     std::vector<Solid>& solids) {
  const bool in = node.states.has(Predicate::PluggedIn);
  if (!in && !node.states.has(Predicate::Unplugged)) return;
  constexpr double kPlate_m = 0.1, kOnFloor_m = 0.065;
  const double plug = on_floor(node) ? kOnFloor_m : std::clamp(0.2 * node.size.maxCoeff(), 0.028, 0.04);
  if (in) {
    if (const auto socket = wall_socket(node, kPlate_m, walls)) {
      Boxes boxes(socket->pose, owner, solids);
      return add_in_wall(*socket, kPlate_m, boxes);
    }
  }
  Boxes boxes(node.pose, owner, solids);
  if (in || !on_floor(node)) return add_beside(node, in, plug, boxes);
  add_before(node, plug, boxes);
}

}  // namespace unietp
