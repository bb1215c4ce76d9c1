#include "simulation/navigation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "simulation/walls.h"

namespace unietp {
namespace {

constexpr double kDoorway_m = 0.2;    // to either side of an opening's line
constexpr double kStepOver_m = 0.05;  // lower things on the floor do not stop a body
constexpr double kLow_m = 0.15;       // movable things that start higher lie on furniture, which blocks the way itself
constexpr std::array<std::array<int, 2>, 4> kNeighbours{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

/// A solid seen from above: a rectangle turned by its yaw, or its bounds when it does not stand upright.
struct Footprint {
  Vec2 centre, along, half;  // `along`: unit, the rectangle's own x
};

std::optional<Footprint> footprint_of(const Pose& pose, const Vec3& size, double body_height) {
  const Bounds bounds = bounds_of(pose, size);
  if (bounds.high.z() < kStepOver_m || bounds.low.z() > body_height) return std::nullopt;
  const Vec3 up = pose.rotation * Vec3::UnitZ();
  if (std::abs(up.z()) > 0.999) {
    const Vec3 x = pose.rotation * Vec3::UnitX();
    return Footprint{pose.position.head<2>(), x.head<2>().normalized(), size.head<2>() / 2};
  }
  return Footprint{(bounds.low + bounds.high).head<2>() / 2, Vec2::UnitX(), (bounds.high - bounds.low).head<2>() / 2};
}

double distance_to(const Footprint& f, const Vec2& point) {
  const Vec2 d = point - f.centre;
  const Vec2 local(std::abs(d.dot(f.along)), std::abs(d.dot(Vec2(-f.along.y(), f.along.x()))));
  return (local - f.half).cwiseMax(0.0).norm();
}

std::vector<Footprint> footprints_of(const Node& node, const Shape& shape, double opening, double body_height,
                                     bool only_moving) {
  std::vector<Footprint> all;
  for (const Part& part : shape.parts) {
    if (only_moving && part.joint < 0) continue;
    const Pose pose = node.pose * joint_motion(shape, part.joint, opening) * part.pose;
    if (const auto f = footprint_of(pose, part.size, body_height)) all.push_back(*f);
  }
  return all;
}

/// All that the moving parts sweep, in steps.
std::vector<Footprint> door_way(const Node& node, const Profile& profile) {
  std::vector<Footprint> way;
  if (!node.openable) return way;
  const Shape shape = shape_of(node);
  for (const double opening : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const auto parts = footprints_of(node, shape, opening, profile.body_height_m, true);
    way.insert(way.end(), parts.begin(), parts.end());
  }
  return way;
}

bool within(const std::vector<Footprint>& footprints, const Vec2& at, double radius) {
  return std::any_of(footprints.begin(), footprints.end(),
                     [&](const Footprint& f) { return distance_to(f, at) < radius; });
}

}  // namespace

bool stands_low(const Bounds& bounds) { return bounds.low.z() < kLow_m; }

bool in_door_way(const Node& node, const Vec2& at, const Profile& profile) {
  return within(door_way(node, profile), at, profile.body_radius_m);
}

NavigationGrid::NavigationGrid(const Scene& scene, const Profile& profile) {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Room& room : scene.rooms) {
    for (const Vec2& p : room.polygon) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  if (scene.rooms.empty()) return;
  origin_ = low;
  width_ = static_cast<int>(std::ceil((high.x() - low.x()) / kCell_m));
  height_ = static_cast<int>(std::ceil((high.y() - low.y()) / kCell_m));
  blocked_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 1);
  for (const Room& room : scene.rooms) {
    Vec2 room_low = room.polygon.front(), room_high = room_low;
    for (const Vec2& p : room.polygon) {
      room_low = room_low.cwiseMin(p);
      room_high = room_high.cwiseMax(p);
    }
    const Cell from = cell_at(room_low), to = cell_at(room_high);
    for (int y = std::max(0, from.y); y <= std::min(height_ - 1, to.y); ++y) {
      for (int x = std::max(0, from.x); x <= std::min(width_ - 1, to.x); ++x) {
        if (contains(room.polygon, centre({x, y}))) blocked_[index({x, y})] = 0;
      }
    }
  }
  // Some files draw rooms up to their walls' inner faces: then the doorway lies between them.
  for (const Opening& opening : scene.openings) {
    const Vec2 along = opening.to - opening.from;
    const double length = along.norm();
    if (!(length > 0)) continue;
    const Vec2 reach = Vec2::Constant(kDoorway_m);
    const Cell from = cell_at(opening.from.cwiseMin(opening.to) - reach);
    const Cell to = cell_at(opening.from.cwiseMax(opening.to) + reach);
    for (int y = std::max(0, from.y); y <= std::min(height_ - 1, to.y); ++y) {
      for (int x = std::max(0, from.x); x <= std::min(width_ - 1, to.x); ++x) {
        const Vec2 way = centre({x, y}) - opening.from;
        const double at = way.dot(along) / length, aside = way.x() * along.y() - way.y() * along.x();
        if (at >= 0 && at <= length && std::abs(aside) / length <= kDoorway_m) blocked_[index({x, y})] = 0;
      }
    }
  }
  const double radius = profile.body_radius_m;
  const auto block = [&](const Footprint& f) {
    const double reach = f.half.norm() + radius;
    const Cell from = cell_at(f.centre - Vec2::Constant(reach)), to = cell_at(f.centre + Vec2::Constant(reach));
    for (int y = std::max(0, from.y); y <= std::min(height_ - 1, to.y); ++y) {
      for (int x = std::max(0, from.x); x <= std::min(width_ - 1, to.x); ++x) {
        if (distance_to(f, centre({x, y})) < radius) blocked_[index({x, y})] = 1;
      }
    }
  };
  for (const WallPiece& piece : walls_of(scene)) {
    if (const auto f = footprint_of(piece.pose, piece.size, profile.body_height_m)) block(*f);
  }
  for (const Node& node : scene.nodes) {
    if (std::find(scene.agent.held.begin(), scene.agent.held.end(), node.id) != scene.agent.held.end()) continue;
    if (node.movable && !stands_low(bounds_of(node.pose, node.size))) continue;
    for (const Footprint& f : footprints_of(node, shape_of(node), node.opening, profile.body_height_m, false)) block(f);
  }
}

bool NavigationGrid::free(Cell cell) const {
  return cell.x >= 0 && cell.y >= 0 && cell.x < width_ && cell.y < height_ && blocked_[index(cell)] == 0;
}

NavigationGrid::Cell NavigationGrid::cell_at(const Vec2& point) const {
  const Vec2 cells = (point - origin_) / kCell_m;
  return {static_cast<std::int32_t>(std::floor(cells.x())), static_cast<std::int32_t>(std::floor(cells.y()))};
}

Vec2 NavigationGrid::centre(Cell cell) const {
  return origin_ + Vec2((cell.x + 0.5) * kCell_m, (cell.y + 0.5) * kCell_m);
}

std::vector<std::int32_t> NavigationGrid::distances(Cell from) const {
  std::vector<std::int32_t> steps(blocked_.size(), -1);
  if (!free(from)) return steps;
  std::vector<Cell> front{from};
  steps[index(from)] = 0;
  for (std::size_t at = 0; at < front.size(); ++at) {
    const Cell cell = front[at];
    const std::int32_t next_steps = steps[index(cell)] + 1;
    for (const auto& d : kNeighbours) {
      const Cell next{cell.x + d[0], cell.y + d[1]};
      if (!free(next)) continue;
      std::int32_t& known = steps[index(next)];
      if (known >= 0) continue;
      known = next_steps;
      front.push_back(next);
    }
  }
  return steps;
}

std::optional<NavigationGrid::Cell> NavigationGrid::nearest_free(const Vec2& point) const {
  std::optional<Cell> best;
  double best_distance = std::numeric_limits<double>::infinity();
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      if (!free({x, y})) continue;
      const double d = (centre({x, y}) - point).squaredNorm();
      if (d < best_distance) {
        best_distance = d;
        best = Cell{x, y};
      }
    }
  }
  return best;
}

std::vector<NavigationGrid::Cell> NavigationGrid::path(Cell from, Cell to) const {
  const auto steps = distances(to);
  std::vector<Cell> cells;
  const auto at = [&](Cell c) { return steps[index(c)]; };
  if (!free(from) || at(from) < 0) return cells;
  cells.push_back(from);
  while (at(cells.back()) > 0) {
    for (const auto& d : kNeighbours) {
      const Cell next{cells.back().x + d[0], cells.back().y + d[1]};
      if (free(next) && at(next) == at(cells.back()) - 1) {
        cells.push_back(next);
        break;
      }
    }
  }
  return cells;
}

std::vector<Vec2> NavigationGrid::walk(const Vec2& from, const Vec2& to) const {
  const std::vector<Cell> cells = path(nearest_free(from).value_or(Cell{}), nearest_free(to).value_or(Cell{}));
  if (cells.empty()) return {};
  const auto straight = [&](const Vec2& a, const Vec2& b) {
    const int samples = 1 + static_cast<int>(4 * (b - a).norm() / kCell_m);
    for (int i = 0; i <= samples; ++i) {
      if (!free(cell_at(a + (b - a) * i / samples))) return false;
    }
    return true;
  };
  std::vector<Vec2> points{from};
  for (std::size_t at = 0; at + 1 < cells.size();) {
    std::size_t next = cells.size() - 1;
    while (next > at + 1 && !straight(centre(cells[at]), centre(cells[next]))) --next;
    at = next;
    points.push_back(at + 1 == cells.size() ? to : centre(cells[at]));
  }
  return points;
}

double reach_distance(const Node& node, const Vec2& at, const Profile& profile) {
  const Vec3 up = node.pose.rotation * Vec3::UnitZ();
  if (std::abs(up.z()) > 1 - 1e-9) {  // upright, as most things are: a rectangle and an interval of heights
    const Vec3 x = node.pose.rotation * Vec3::UnitX();
    const double sideways = distance_to({node.pose.position.head<2>(), x.head<2>(), node.size.head<2>() / 2}, at);
    const double low = node.pose.position.z() - node.size.z() / 2, high = low + node.size.z();
    return std::hypot(sideways, std::max({0.0, low - profile.body_height_m, -high}));
  }
  const Pose to_node = inverse(node.pose);
  const auto distance = [&](double z) {
    const Vec3 local = to_node * Vec3(at.x(), at.y(), z);
    return (local.cwiseAbs() - node.size / 2).cwiseMax(0.0).norm();
  };
  double low = 0, high = profile.body_height_m;  // the distance is convex along the segment
  for (int i = 0; i < 40; ++i) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    if (distance(a) <= distance(b)) {
      high = b;
    } else {
      low = a;
    }
  }
  return distance((low + high) / 2);
}

std::vector<Vec3> sight_points(const Node& node) {
  constexpr double kInside = 0.9;  // of the way from the centre to a face
  std::vector<Vec3> points{node.pose.position};
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {1.0, -1.0}) {
      Vec3 local = Vec3::Zero();
      local[axis] = side * kInside * node.size[axis] / 2;
      points.push_back(node.pose * local);
    }
  }
  for (int i = 7; i >= 0; --i) {  // upper corners first: they are the likelier to be seen
    const Vec3 side((i & 1) ? 1 : -1, (i & 2) ? 1 : -1, (i & 4) ? 1 : -1);
    points.push_back(node.pose * (kInside / 2 * side.cwiseProduct(node.size)));
  }
  return points;
}

bool sees(const Scene& scene, const PhysicsWorld& world, const Profile& profile, const Vec2& at, std::size_t node,
          std::span<const BodyId> ignore) {
  const Vec3 camera(at.x(), at.y(), profile.camera_height_m);
  const std::vector<Vec3> points = sight_points(scene.nodes[node]);
  return std::any_of(points.begin(), points.end(), [&](const Vec3& point) {
    const auto hit = world.ray(camera, point, ignore);
    return !hit || hit->body == node;
  });
}

std::optional<Vec2> standing_place(const Scene& scene, const PhysicsWorld& world, const NavigationGrid& grid,
                                   const std::vector<std::int32_t>& walk_from_agent, const Profile& profile,
                                   std::size_t node, std::span<const BodyId> ignore) {
  constexpr double kReachReserve_m = 0.02;
  constexpr double kFrontWeight_m = 0.5;  // standing behind costs as much as standing this much farther away, twice
  constexpr double kAsideWeight = 2;
  constexpr int kMostChecked = 80;
  const Node& target = scene.nodes[node];
  const std::vector<Footprint> way = door_way(target, profile);
  const Vec3 front = target.pose.rotation * -Vec3::UnitY();
  const Pose to_target = inverse(target.pose);
  struct Candidate {
    double cost;
    NavigationGrid::Cell cell;
  };
  std::vector<Candidate> candidates;
  const double span = target.size.norm() / 2 + profile.reach_m;
  const Vec2 middle = target.pose.position.head<2>();
  const auto from = grid.cell_at(middle - Vec2::Constant(span)), to = grid.cell_at(middle + Vec2::Constant(span));
  for (int y = from.y; y <= to.y; ++y) {
    for (int x = from.x; x <= to.x; ++x) {
      const NavigationGrid::Cell cell{x, y};
      if (!grid.free(cell) || walk_from_agent[grid.index({x, y})] < 0) continue;
      const Vec2 at = grid.centre(cell);
      const double distance = reach_distance(target, at, profile);
      if (distance > profile.reach_m - kReachReserve_m) continue;
      double cost = distance;
      if (!target.movable && (at - middle).norm() > 1e-9) {
        cost += kFrontWeight_m * (1 - (at - middle).normalized().dot(front.head<2>()));
      }
      if (target.openable && !target.movable) {  // where one can look into it once it is open: squarely before it
        const Vec3 local = to_target * Vec3(at.x(), at.y(), target.pose.position.z());
        const double aside = std::max(0.0, std::abs(local.x()) - target.size.x() / 2);
        cost += kAsideWeight * aside + (local.y() > -target.size.y() / 2 ? kAsideWeight : 0);
      }
      candidates.push_back({cost, cell});
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  int checked = 0;
  for (const Candidate& candidate : candidates) {
    const Vec2 at = grid.centre(candidate.cell);
    if (within(way, at, profile.body_radius_m)) continue;
    if (++checked > kMostChecked) break;
    if (sees(scene, world, profile, at, node, ignore)) return at;
  }
  return std::nullopt;
}

}  // namespace unietp
