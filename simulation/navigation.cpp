#include "simulation/navigation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <tuple>
#include <utility>

#include "simulation/walls.h"

namespace unietp {
namespace {

constexpr double kDoorway_m = 0.2;    // to either side of an opening's line
constexpr double kStepOver_m = 0.05;  // lower things on the floor do not stop a body
constexpr double kLow_m = 0.15;       // movable things that start higher lie on furniture, which blocks the way itself
constexpr std::array<std::array<int, 2>, 4> kNeighbours{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

std::optional<Shadow> shadow_of_part(const Pose& pose, const Vec3& size, double body_height) {
  const Bounds bounds = bounds_of(pose, size);
  if (bounds.high.z() < kStepOver_m || bounds.low.z() > body_height) return std::nullopt;
  const Vec3 up = pose.rotation * Vec3::UnitZ();
  if (std::abs(up.z()) > 0.999) {
    const Vec3 x = pose.rotation * Vec3::UnitX();
    return Shadow{pose.position.head<2>(), x.head<2>().normalized(), size.head<2>() / 2};
  }
  return Shadow{(bounds.low + bounds.high).head<2>() / 2, Vec2::UnitX(), (bounds.high - bounds.low).head<2>() / 2};
}

double distance_to(const Shadow& f, const Vec2& point) {
  const Vec2 d = point - f.centre;
  const Vec2 local(std::abs(d.dot(f.along)), std::abs(d.dot(Vec2(-f.along.y(), f.along.x()))));
  return (local - f.half).cwiseMax(0.0).norm();
}

/// Lies in the other, and so adds nothing to it.
bool covered(const Shadow& f, const Shadow& by) {
  if (f.along != by.along) return false;
  const Vec2 d = f.centre - by.centre;
  const Vec2 local(std::abs(d.dot(by.along)), std::abs(d.dot(Vec2(-by.along.y(), by.along.x()))));
  return ((local + f.half - by.half).array() <= 0).all();
}

std::vector<Shadow> shadows_of(const Node& node, const Shape& shape, double opening, double body_height,
                               bool only_moving) {
  std::vector<Shadow> all;
  for (const Part& part : shape.parts) {
    if (only_moving && part.joint < 0) continue;
    const Pose pose = node.pose * joint_motion(shape, part.joint, opening) * part.pose;
    const auto f = shadow_of_part(pose, part.size, body_height);
    if (!f || std::any_of(all.begin(), all.end(), [&](const Shadow& other) { return covered(*f, other); })) continue;
    std::erase_if(all, [&](const Shadow& other) { return covered(other, *f); });
    all.push_back(*f);
  }
  return all;
}

/// What of a node stands in the way of a body.
std::vector<Shadow> shadow_of(const Node& node, const Shape& shape, double body_height) {
  if (node.movable && !stands_low(bounds_of(node.pose, node.size))) return {};
  return shadows_of(node, shape, node.opening, body_height, false);
}

/// All that the moving parts sweep, in steps.
std::vector<Shadow> door_way(const Node& node, const Shape& shape, const Profile& profile) {
  std::vector<Shadow> way;
  if (!node.openable) return way;
  for (const double opening : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const auto parts = shadows_of(node, shape, opening, profile.body_height_m, true);
    way.insert(way.end(), parts.begin(), parts.end());
  }
  return way;
}

bool within(const std::vector<Shadow>& footprints, const Vec2& at, double radius) {
  return std::any_of(footprints.begin(), footprints.end(),
                     [&](const Shadow& f) { return distance_to(f, at) < radius; });
}

}  // namespace

bool stands_low(const Bounds& bounds) { return bounds.low.z() < kLow_m; }

bool in_door_way(const Node& node, const Vec2& at, const Profile& profile) {
  return within(door_way(node, shape_of(node), profile), at, profile.body_radius_m);
}

NavigationGrid::NavigationGrid(const Scene& scene, const Profile& profile)
    : body_radius_(profile.body_radius_m), body_height_(profile.body_height_m), shadows_(scene.nodes.size()) {
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
  blockers_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 1);
  for (const Room& room : scene.rooms) {
    Vec2 room_low = room.polygon.front(), room_high = room_low;
    for (const Vec2& p : room.polygon) {
      room_low = room_low.cwiseMin(p);
      room_high = room_high.cwiseMax(p);
    }
    const Cell from = cell_at(room_low), to = cell_at(room_high);
    for (int y = std::max(0, from.y); y <= std::min(height_ - 1, to.y); ++y) {
      for (int x = std::max(0, from.x); x <= std::min(width_ - 1, to.x); ++x) {
        if (contains(room.polygon, centre({x, y}))) blockers_[index({x, y})] = 0;
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
        if (at >= 0 && at <= length && std::abs(aside) / length <= kDoorway_m) blockers_[index({x, y})] = 0;
      }
    }
  }
  for (const WallPiece& piece : walls_of(scene)) {
    if (const auto f = shadow_of_part(piece.pose, piece.size, body_height_)) count(*f, 1);
  }
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    if (std::find(scene.agent.held.begin(), scene.agent.held.end(), node.id) != scene.agent.held.end()) continue;
    const Shape shape = shape_of(node);
    update(i, &node, &shape);
  }
}

void NavigationGrid::count(const Shadow& f, int by) {
  const Vec2 &u = f.along, v(-f.along.y(), f.along.x());
  const Vec2 reach = u.cwiseAbs() * f.half.x() + v.cwiseAbs() * f.half.y() + Vec2::Constant(body_radius_);
  const Cell from = cell_at(f.centre - reach), to = cell_at(f.centre + reach);
  const double limit = body_radius_ * body_radius_;
  for (int y = std::max(0, from.y); y <= std::min(height_ - 1, to.y); ++y) {
    for (int x = std::max(0, from.x); x <= std::min(width_ - 1, to.x); ++x) {
      const Vec2 d = centre({x, y}) - f.centre;
      const double out_u = std::max(0.0, std::abs(d.dot(u)) - f.half.x());
      const double out_v = std::max(0.0, std::abs(d.dot(v)) - f.half.y());
      if (out_u * out_u + out_v * out_v >= limit) continue;
      std::uint16_t& blockers = blockers_[index({x, y})];
      blockers = static_cast<std::uint16_t>(blockers + by);
    }
  }
}

void NavigationGrid::update(std::size_t i, const Node* node, const Shape* shape) {
  if (i >= shadows_.size()) shadows_.resize(i + 1);
  std::vector<Shadow> shadow;
  if (node != nullptr) shadow = shadow_of(*node, *shape, body_height_);
  if (shadow == shadows_[i]) return;
  for (const Shadow& f : shadows_[i]) count(f, -1);
  for (const Shadow& f : shadow) count(f, 1);
  shadows_[i] = std::move(shadow);
  ++version_;
}

bool NavigationGrid::free(Cell cell) const {
  return cell.x >= 0 && cell.y >= 0 && cell.x < width_ && cell.y < height_ && blockers_[index(cell)] == 0;
}

NavigationGrid::Cell NavigationGrid::cell_at(const Vec2& point) const {
  const Vec2 cells = (point - origin_) / kCell_m;
  return {static_cast<std::int32_t>(std::floor(cells.x())), static_cast<std::int32_t>(std::floor(cells.y()))};
}

Vec2 NavigationGrid::centre(Cell cell) const {
  return origin_ + Vec2((cell.x + 0.5) * kCell_m, (cell.y + 0.5) * kCell_m);
}

std::vector<std::int32_t> NavigationGrid::distances(Cell from) const {
  std::vector<std::int32_t> steps(blockers_.size(), -1);
  if (!free(from)) return steps;
  // Cells that are free and not reached yet, with a border around them that is neither: no step asks where it is.
  const std::int32_t wide = width_ + 2;
  std::vector<std::uint8_t> open(static_cast<std::size_t>(wide) * static_cast<std::size_t>(height_ + 2), 0);
  for (std::int32_t y = 0; y < height_; ++y) {
    const std::uint16_t* row = blockers_.data() + index({0, y});
    std::uint8_t* padded = open.data() + static_cast<std::size_t>(y + 1) * static_cast<std::size_t>(wide) + 1;
    for (std::int32_t x = 0; x < width_; ++x) padded[x] = row[x] == 0;
  }
  struct Place {
    std::int32_t padded, own;  // in `open` and in `steps`
  };
  const std::array<Place, 4> ways{{{1, 1}, {-1, -1}, {wide, width_}, {-wide, -width_}}};
  std::vector<Place> front{{(from.y + 1) * wide + from.x + 1, static_cast<std::int32_t>(index(from))}}, next;
  open[static_cast<std::size_t>(front.front().padded)] = 0;
  for (std::int32_t far = 0; !front.empty(); ++far) {
    next.clear();
    for (const Place& place : front) {
      steps[static_cast<std::size_t>(place.own)] = far;
      for (const Place& way : ways) {
        std::uint8_t& is_open = open[static_cast<std::size_t>(place.padded + way.padded)];
        if (is_open == 0) continue;
        is_open = 0;
        next.push_back({place.padded + way.padded, place.own + way.own});
      }
    }
    front.swap(next);
  }
  return steps;
}

std::optional<NavigationGrid::Cell> NavigationGrid::nearest_free(const Vec2& point) const {
  const Cell middle = cell_at(point);
  std::optional<Cell> best;
  double best_distance = std::numeric_limits<double>::infinity();
  const auto look = [&](int x, int y) {
    const Cell cell{x, y};
    if (!free(cell)) return;
    const double d = (centre(cell) - point).squaredNorm();
    const bool nearer = d < best_distance || (d == best_distance && std::pair(y, x) < std::pair(best->y, best->x));
    if (!nearer) return;
    best_distance = d;
    best = cell;
  };
  const int farthest = std::max({middle.x, middle.y, width_ - 1 - middle.x, height_ - 1 - middle.y});
  for (int ring = 0; ring <= farthest; ++ring) {
    const double least = (ring - 0.5) * kCell_m;  // from the point to the centre of a cell of this ring
    if (best && ring > 0 && least * least > best_distance) break;
    for (int y = std::max(0, middle.y - ring); y <= std::min(height_ - 1, middle.y + ring); ++y) {
      const bool whole_row = std::abs(y - middle.y) == ring;
      const int step = whole_row || ring == 0 ? 1 : 2 * ring;
      for (int x = middle.x - ring; x <= middle.x + ring; x += step) look(x, y);
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

namespace {

/// Distances of many points from one node: from the body's vertical segment at a point to the node's box.
class Reach {
 public:
  Reach(const Node& node, const Profile& profile) : half_(node.size / 2), height_(profile.body_height_m) {
    const Vec3 up = node.pose.rotation * Vec3::UnitZ();
    upright_ = std::abs(up.z()) > 1 - 1e-9;
    if (upright_) {  // as most things are: a rectangle and an interval of heights
      const Vec3 x = node.pose.rotation * Vec3::UnitX();
      rectangle_ = {node.pose.position.head<2>(), x.head<2>(), half_.head<2>()};
      const double low = node.pose.position.z() - half_.z(), high = low + node.size.z();
      above_ = std::max({0.0, low - height_, -high});
    } else {
      to_node_ = inverse(node.pose);
    }
  }

  /// Whether it is certainly more than `limit`, at a fraction of the cost; false says nothing.
  bool beyond(const Vec2& at, double limit) const {
    constexpr double kSlack = 1e-9;
    if (!upright_) return false;
    const Vec2 d = at - rectangle_.centre;
    const double out_u = std::max(0.0, std::abs(d.dot(rectangle_.along)) - rectangle_.half.x());
    const double out_v =
        std::max(0.0, std::abs(d.y() * rectangle_.along.x() - d.x() * rectangle_.along.y()) - rectangle_.half.y());
    return out_u * out_u + out_v * out_v + above_ * above_ > limit * limit + kSlack;
  }

  double operator()(const Vec2& at) const {
    if (upright_) return std::hypot(distance_to(rectangle_, at), above_);
    const auto distance = [&](double z) {
      const Vec3 local = to_node_ * Vec3(at.x(), at.y(), z);
      return (local.cwiseAbs() - half_).cwiseMax(0.0).norm();
    };
    double low = 0, high = height_;  // the distance is convex along the segment
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

 private:
  Vec3 half_;
  double height_ = 0, above_ = 0;
  bool upright_ = false;
  Shadow rectangle_;
  Pose to_node_;
};

}  // namespace

double reach_distance(const Node& node, const Vec2& at, const Profile& profile) { return Reach(node, profile)(at); }

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

bool sees(const Node& thing, BodyId body, const PhysicsWorld& world, const Profile& profile, const Vec2& at,
          std::span<const BodyId> ignore) {
  const Vec3 camera(at.x(), at.y(), profile.camera_height_m);
  const std::vector<Vec3> points = sight_points(thing);
  return std::any_of(points.begin(), points.end(), [&](const Vec3& point) {
    const auto hit = world.ray(camera, point, ignore);
    return !hit || hit->body == body;
  });
}

bool sees(const Scene& scene, const PhysicsWorld& world, const Profile& profile, const Vec2& at, std::size_t node,
          std::span<const BodyId> ignore) {
  return sees(scene.nodes[node], static_cast<BodyId>(node), world, profile, at, ignore);
}

std::optional<Vec2> standing_place(const Scene& scene, const PhysicsWorld& world, const NavigationGrid& grid,
                                   const std::vector<std::int32_t>& walk_from_agent, const Profile& profile,
                                   std::size_t node, std::span<const BodyId> ignore) {
  constexpr double kReachReserve_m = 0.02;
  constexpr double kFrontWeight_m = 0.5;  // standing behind costs as much as standing this much farther away, twice
  constexpr double kAsideWeight = 2;
  constexpr int kMostChecked = 80;
  const Node& target = scene.nodes[node];
  const auto body = static_cast<BodyId>(node);
  const std::vector<Shadow> way =
      door_way(target, world.has(body) ? world.collider(body).shape : shape_of(target), profile);
  const Reach reach(target, profile);
  const Vec3 front = target.pose.rotation * -Vec3::UnitY();
  const Pose to_target = inverse(target.pose);
  struct Candidate {
    double cost;
    NavigationGrid::Cell cell;
    bool operator>(const Candidate& other) const {
      return std::tie(cost, cell.y, cell.x) > std::tie(other.cost, other.cell.y, other.cell.x);
    }
  };
  std::vector<Candidate> candidates;
  const Bounds bounds = bounds_of(target.pose, target.size);
  const Vec2 span = Vec2::Constant(profile.reach_m), middle = target.pose.position.head<2>();
  const auto from = grid.cell_at(bounds.low.head<2>() - span), to = grid.cell_at(bounds.high.head<2>() + span);
  for (int y = from.y; y <= to.y; ++y) {
    for (int x = from.x; x <= to.x; ++x) {
      const NavigationGrid::Cell cell{x, y};
      if (!grid.free(cell) || walk_from_agent[grid.index({x, y})] < 0) continue;
      const Vec2 at = grid.centre(cell);
      if (reach.beyond(at, profile.reach_m - kReachReserve_m)) continue;
      const double distance = reach(at);
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
  // One of the first few mostly does, so the others need no order.
  std::make_heap(candidates.begin(), candidates.end(), std::greater<>());
  int checked = 0;
  while (!candidates.empty()) {
    std::pop_heap(candidates.begin(), candidates.end(), std::greater<>());
    const Candidate candidate = candidates.back();
    candidates.pop_back();
    const Vec2 at = grid.centre(candidate.cell);
    if (within(way, at, profile.body_radius_m)) continue;
    if (++checked > kMostChecked) break;
    if (sees(scene, world, profile, at, node, ignore)) return at;
  }
  return std::nullopt;
}

}  // namespace unietp
