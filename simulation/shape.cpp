#include "simulation/shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/archetype_dimensions.h"
#include "simulation/board_surfaces.h"

namespace unietp {
namespace {

constexpr double kDoorTravel_rad = std::numbers::pi / 2;

/// Collects parts given by their low and high corners.
class Builder {
 public:
  explicit Builder(const Vec3& size) : half_(size / 2) {}

  void box(const Vec3& low, const Vec3& high, int joint = -1) {
    if ((high - low).minCoeff() <= 0) return;
    shape.parts.push_back({Part::Kind::Box, {(low + high) / 2, Quat::Identity()}, high - low, joint});
  }
  void surface(double x0, double x1, double y0, double y1, double z, double clearance, int cavity = -1,
               int joint = -1) {
    const Vec2 half((x1 - x0) / 2 - kSurfaceEdge_m, (y1 - y0) / 2 - kSurfaceEdge_m);
    if (half.minCoeff() <= 0) return;
    shape.surfaces.push_back({Vec3((x0 + x1) / 2, (y0 + y1) / 2, z), half, clearance, joint, cavity});
  }
  int cavity(const Vec3& low, const Vec3& high, bool closable, bool open_above, int joint = -1) {
    shape.cavities.push_back({(low + high) / 2, (high - low) / 2, joint, closable, open_above});
    return static_cast<int>(shape.cavities.size()) - 1;
  }
  int joint(Joint::Kind kind, const Vec3& anchor, const Vec3& axis, double travel) {
    shape.joints.push_back({kind, anchor, axis, travel});
    return static_cast<int>(shape.joints.size()) - 1;
  }
  const Vec3& half() const { return half_; }

  Shape shape;

 private:
  Vec3 half_;
};

void solid(Builder& b, bool surface_on_top) {
  const Vec3 h = b.half();
  b.box(-h, h);
  if (surface_on_top) b.surface(-h.x(), h.x(), -h.y(), h.y(), h.z(), kOpenAbove_m);
}

void round_solid(Builder& b, Part::Kind kind) {
  const Vec3 h = b.half();
  const double diameter = h.x() + h.y();
  const Vec3 size = kind == Part::Kind::Sphere ? Vec3::Constant(2 * h.z()) : Vec3(diameter, diameter, 2 * h.z());
  b.shape.parts.push_back({kind, {}, size, -1});
  const double inscribed = 0.35 * diameter;
  if (kind == Part::Kind::Cylinder) b.surface(-inscribed, inscribed, -inscribed, inscribed, h.z(), kOpenAbove_m);
}

void table(Builder& b) {
  const Vec3 h = b.half();
  const auto [top, leg] = table_dimensions(2 * h);
  b.box({-h.x(), -h.y(), h.z() - top}, h);
  for (const double x : {-h.x(), h.x() - leg}) {
    for (const double y : {-h.y(), h.y() - leg}) b.box({x, y, -h.z()}, {x + leg, y + leg, h.z() - top});
  }
  b.surface(-h.x(), h.x(), -h.y(), h.y(), h.z(), kOpenAbove_m);
}

void seat(Builder& b) {
  const Vec3 h = b.half();
  const double back = seat_dimensions(2 * h).back;
  const double level = 0;  // half as high as the back
  b.box(-h, {h.x(), h.y() - back, level});
  b.box({-h.x(), h.y() - back, -h.z()}, h);
  b.surface(-h.x(), h.x(), -h.y(), h.y() - back, level, kOpenAbove_m);
}

/// A mattress on legs with a headboard, and free space below.
void bed(Builder& b) {
  const Vec3 h = b.half();
  const auto [back, height, gap, leg] = bed_dimensions(2 * h);
  b.box({-h.x(), -h.y(), -h.z() + gap}, {h.x(), h.y() - back, -h.z() + height});
  b.box({-h.x(), h.y() - back, -h.z()}, h);
  for (const double x : {-h.x(), h.x() - leg}) b.box({x, -h.y(), -h.z()}, {x + leg, -h.y() + leg, -h.z() + gap});
  b.surface(-h.x(), h.x(), -h.y(), h.y() - back, -h.z() + height, kOpenAbove_m);
}

void shelf(Builder& b) {
  const Vec3 h = b.half();
  const auto [bays, board, pitch] = shelf_dimensions(2 * h);
  if (bays == 0) return solid(b, true);
  b.box(-h, {-h.x() + board, h.y(), h.z()});
  b.box({h.x() - board, -h.y(), -h.z()}, h);
  b.box({-h.x() + board, h.y() - board, -h.z()}, {h.x() - board, h.y(), h.z()});
  for (int k = 0; k <= bays; ++k) {
    const double z = -h.z() + k * pitch;
    b.box({-h.x() + board, -h.y(), z}, {h.x() - board, h.y() - board, z + board});
    b.surface(-h.x() + board, h.x() - board, -h.y(), h.y() - board, z + board,
              k == bays ? kOpenAbove_m : pitch - board);
  }
}

void doors(Builder& b, double thickness) {
  const Vec3 h = b.half();
  const bool two = 2 * h.x() > 0.8;
  const double split = two ? 0.0 : h.x();
  const int left = b.joint(Joint::Kind::Hinge, {-h.x(), -h.y(), 0}, -Vec3::UnitZ(), kDoorTravel_rad);
  b.box(-h, {split - (two ? kDoorGap_m : 0), -h.y() + thickness, h.z()}, left);
  if (!two) return;
  const int right = b.joint(Joint::Kind::Hinge, {h.x(), -h.y(), 0}, Vec3::UnitZ(), kDoorTravel_rad);
  b.box({kDoorGap_m, -h.y(), -h.z()}, {h.x(), -h.y() + thickness, h.z()}, right);
}

void cabinet(Builder& b, bool openable) {
  const Vec3 h = b.half();
  const auto [wall, bays, pitch, set_back] = cabinet_dimensions(2 * h);
  const double front = openable ? -h.y() + wall + kDoorGap_m : -h.y();
  const Vec3 low(-h.x() + wall, front, -h.z() + wall), high(h.x() - wall, h.y() - wall, h.z() - wall);
  b.box({-h.x(), front, -h.z()}, {low.x(), h.y(), h.z()});
  b.box({high.x(), front, -h.z()}, h);
  b.box({low.x(), high.y(), -h.z()}, {high.x(), h.y(), h.z()});
  b.box({low.x(), front, -h.z()}, {high.x(), high.y(), low.z()});
  b.box({low.x(), front, high.z()}, {high.x(), high.y(), h.z()});
  const int hollow = b.cavity(low, high, openable, false);
  for (int k = 0; k < bays; ++k) {
    const double z = low.z() + k * pitch;
    if (k > 0) b.box({low.x(), front + set_back, z - wall}, {high.x(), high.y(), z});
    b.surface(low.x(), high.x(), front + set_back, high.y(), z, pitch - wall, hollow);
  }
  b.surface(-h.x(), h.x(), front, h.y(), h.z(), kOpenAbove_m);
  if (openable) doors(b, wall);
}

/// A chest whose top drawer slides; the rest is solid.
void drawers(Builder& b, bool openable) {
  const Vec3 h = b.half();
  const auto [wall, slot] = drawers_dimensions(2 * h);
  const double slot_low = h.z() - wall - slot;
  b.box(-h, {h.x(), h.y(), slot_low});
  b.box({-h.x(), -h.y(), h.z() - wall}, h);
  b.box({-h.x(), -h.y(), slot_low}, {-h.x() + wall, h.y(), h.z() - wall});
  b.box({h.x() - wall, -h.y(), slot_low}, {h.x(), h.y(), h.z() - wall});
  b.box({-h.x() + wall, h.y() - wall, slot_low}, {h.x() - wall, h.y(), h.z() - wall});
  b.surface(-h.x(), h.x(), -h.y(), h.y(), h.z(), kOpenAbove_m);
  if (!openable) return;
  const double travel = 0.8 * (2 * h.y() - wall);
  const int slide = b.joint(Joint::Kind::Slide, Vec3::Zero(), -Vec3::UnitY(), travel);
  const double x0 = -h.x() + wall + kDoorGap_m, x1 = h.x() - wall - kDoorGap_m;
  const double y0 = -h.y(), y1 = h.y() - wall - kDoorGap_m;
  const double z0 = slot_low + kDoorGap_m, z1 = h.z() - wall - kDoorGap_m;
  const double rim = z0 + 0.7 * (z1 - z0);
  b.box({x0, y0, z0}, {x1, y1, z0 + wall}, slide);
  b.box({x0, y0, z0 + wall}, {x1, y0 + wall, z1}, slide);
  b.box({x0, y1 - wall, z0 + wall}, {x1, y1, rim}, slide);
  b.box({x0, y0 + wall, z0 + wall}, {x0 + wall, y1 - wall, rim}, slide);
  b.box({x1 - wall, y0 + wall, z0 + wall}, {x1, y1 - wall, rim}, slide);
  const Vec3 low(x0 + wall, y0 + wall, z0 + wall), high(x1 - wall, y1 - wall, z1);
  const int hollow = b.cavity(low, high, true, false, slide);
  b.surface(low.x(), high.x(), low.y(), high.y(), low.z(), high.z() - low.z(), hollow, slide);
}

/// Walls around a hollow that is open above; `floor_z` is the hollow's floor.
void hollow_block(Builder& b, double wall, double floor_z, double top_z, bool closable) {
  const Vec3 h = b.half();
  b.box(-h, {h.x(), h.y(), floor_z});
  b.box({-h.x(), -h.y(), floor_z}, {-h.x() + wall, h.y(), top_z});
  b.box({h.x() - wall, -h.y(), floor_z}, {h.x(), h.y(), top_z});
  b.box({-h.x() + wall, -h.y(), floor_z}, {h.x() - wall, -h.y() + wall, top_z});
  b.box({-h.x() + wall, h.y() - wall, floor_z}, {h.x() - wall, h.y(), top_z});
  const Vec3 low(-h.x() + wall, -h.y() + wall, floor_z), high(h.x() - wall, h.y() - wall, top_z);
  const int hollow = b.cavity(low, high, closable, true);
  // No margin in small hollows: the surface is the whole floor, less a millimeter.
  b.shape.surfaces.push_back({Vec3(0, 0, floor_z), Vec2(high.x(), high.y()) - Vec2::Constant(0.001),
                              closable ? top_z - floor_z : kOpenAbove_m, -1, hollow});
}

void basin(Builder& b) {
  const Vec3 h = b.half();
  const auto [wall, depth] = basin_dimensions(2 * h);
  hollow_block(b, wall, h.z() - depth, h.z(), false);
}

void vessel(Builder& b) {
  const Vec3 h = b.half();
  const double wall = vessel_wall(2 * h);
  hollow_block(b, wall, -h.z() + wall, h.z(), false);
}

void lidded(Builder& b) {
  const Vec3 h = b.half();
  const double wall = vessel_wall(2 * h);
  hollow_block(b, wall, -h.z() + wall, h.z() - wall - kDoorGap_m / 2, true);
  const int hinge = b.joint(Joint::Kind::Hinge, {0, h.y(), h.z() - wall}, -Vec3::UnitX(), kLidTravel_rad);
  b.box({-h.x(), -h.y(), h.z() - wall}, h, hinge);
}

void folding(Builder& b) {
  const Vec3 h = b.half();
  b.box(-h, {h.x(), h.y(), -kDoorGap_m / 4});
  const int hinge = b.joint(Joint::Kind::Hinge, {0, h.y(), 0}, -Vec3::UnitX(), kLidTravel_rad);
  b.box({-h.x(), -h.y(), kDoorGap_m / 4}, h, hinge);
}

}  // namespace

Shape make_shape(Archetype archetype, const Vec3& size, bool openable) {
  Builder b(size);
  switch (archetype) {
    case Archetype::Block:
      solid(b, true);
      break;
    case Archetype::Table:
      table(b);
      break;
    case Archetype::Seat:
      seat(b);
      break;
    case Archetype::Bed:
      bed(b);
      break;
    case Archetype::Shelf:
      shelf(b);
      break;
    case Archetype::Cabinet:
      cabinet(b, openable);
      break;
    case Archetype::Drawers:
      drawers(b, openable);
      break;
    case Archetype::Basin:
      basin(b);
      break;
    case Archetype::Panel:
    case Archetype::Fixture:
      solid(b, false);
      break;
    case Archetype::Box:
    case Archetype::Plate:
      solid(b, true);
      break;
    case Archetype::Cylinder:
      round_solid(b, Part::Kind::Cylinder);
      break;
    case Archetype::Sphere:
      round_solid(b, Part::Kind::Sphere);
      break;
    case Archetype::Vessel:
      vessel(b);
      break;
    case Archetype::Lidded:
      openable ? lidded(b) : vessel(b);
      break;
    case Archetype::Folding:
      openable ? folding(b) : solid(b, true);
      break;
  }
  return std::move(b.shape);
}

namespace {

int cavity_at(const Shape& shape, const Vec3& point, int joint) {
  for (std::size_t i = 0; i < shape.cavities.size(); ++i) {
    const Cavity& cavity = shape.cavities[i];
    if (cavity.joint != joint) continue;
    if (((point - cavity.center).cwiseAbs() - cavity.half).maxCoeff() < kSurfaceEdge_m) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace

Shape shape_of(const Node& node) {
  Shape shape = make_shape(node.archetype, node.size, node.openable);
  if (node.boards.empty()) return shape;
  std::vector<Board> boards = node.boards;
  shape.parts.clear();
  for (Board& board : boards) {
    if (board.joint >= static_cast<int>(shape.joints.size())) board.joint = -1;
    shape.parts.push_back({Part::Kind::Box, {board.center, Quat::Identity()}, board.size, board.joint});
  }
  shape.surfaces = surfaces_on(boards);
  for (Surface& surface : shape.surfaces) surface.cavity = cavity_at(shape, surface.center, surface.joint);
  return shape;
}

Pose joint_motion(const Shape& shape, int joint, double opening) {
  if (joint < 0) return {};
  const Joint& j = shape.joints[static_cast<std::size_t>(joint)];
  const double position = opening * j.travel;
  if (j.kind == Joint::Kind::Slide) return {j.axis * position, Quat::Identity()};
  const Quat turn(Eigen::AngleAxisd(position, j.axis));
  return {j.anchor - turn * j.anchor, turn};
}

Bounds bounds_of(const Shape& shape, const Pose& pose, double opening) {
  Bounds all{pose.position, pose.position};
  for (const Part& part : shape.parts) {
    const Bounds one = bounds_of(pose * joint_motion(shape, part.joint, opening) * part.pose, part.size);
    all.low = all.low.cwiseMin(one.low);
    all.high = all.high.cwiseMax(one.high);
  }
  return all;
}

}  // namespace unietp
