#include "simulation/standing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <tuple>

#include "simulation/footprint.h"

namespace unietp {
namespace {

constexpr double kReachReserve_m = 0.02;
constexpr double kFrontWeight_m = 0.5;  // standing behind an object costs as much as twice this distance
constexpr double kAsideWeight = 2;
constexpr std::size_t kMostChecked = 80;

/// Distances from the body's vertical segment, at many points, to one node's box.
class Reach {
 public:
  Reach(const Node& node, const Profile& profile) : half_(node.size / 2), height_(profile.body_height_m) {
    const Vec3 up = node.pose.rotation * Vec3::UnitZ();
    upright_ = std::abs(up.z()) > 1 - 1e-9;
    if (upright_) {  // the common case: a rectangle and a height interval
      const Vec3 x = node.pose.rotation * Vec3::UnitX();
      rectangle_ = {node.pose.position.head<2>(), x.head<2>(), half_.head<2>()};
      const double low = node.pose.position.z() - half_.z(), high = low + node.size.z();
      above_ = std::max({0.0, low - height_, -high});
    } else {
      to_node_ = inverse(node.pose);
    }
  }

  /// Cheap test: true only if the distance is more than `limit`.
  bool beyond(const Vec2& at, double limit) const {
    constexpr double kSlack = 1e-9;
    if (!upright_) return false;
    const Vec2 d = at - rectangle_.center;
    const double out_u = std::max(0.0, std::abs(d.dot(rectangle_.along)) - rectangle_.half.x());
    const double out_v =
        std::max(0.0, std::abs(d.y() * rectangle_.along.x() - d.x() * rectangle_.along.y()) - rectangle_.half.y());
    return out_u * out_u + out_v * out_v + above_ * above_ > limit * limit + kSlack;
  }

  double operator()(const Vec2& at) const {
    if (upright_) {
      const double aside = distance_to(rectangle_, at);
      return above_ > 0 ? std::hypot(aside, above_) : aside;
    }
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
  FloorFootprint rectangle_;
  Pose to_node_;
};

}  // namespace

double reach_distance(const Node& node, const Vec2& at, const Profile& profile) { return Reach(node, profile)(at); }

std::vector<Vec3> sight_points(const Node& node) {
  constexpr double kInside = 0.9;  // of the way from the center to a face
  std::vector<Vec3> points{node.pose.position};
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {1.0, -1.0}) {
      Vec3 local = Vec3::Zero();
      local[axis] = side * kInside * node.size[axis] / 2;
      points.push_back(node.pose * local);
    }
  }
  for (int i = 7; i >= 0; --i) {  // upper corners first, since they are more likely visible
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
  return sees(scene.nodes[node], BodyId::node(node), world, profile, at, ignore);
}

void StandingCells::look_farther(const StandingInputs& asked, double limit_m) {
  constexpr double kFirst_m = 0.75;  // enough for most objects on tables
  const auto& [target, shape, grid, walk, profile] = asked;
  const double limit = std::min(limit_m, looked_m_ < 0 ? kFirst_m : 2 * looked_m_);
  if (looked_m_ < 0) way_ = door_sweep(target, shape, profile);
  const Reach reach(target, profile);
  const Vec3 front = target.pose.rotation * -Vec3::UnitY();
  const Pose to_target = inverse(target.pose);
  const Bounds bounds = bounds_of(target.pose, target.size);
  const Vec2 span = Vec2::Constant(limit), middle = target.pose.position.head<2>();
  const auto from = grid.cell_at(bounds.low.head<2>() - span), to = grid.cell_at(bounds.high.head<2>() + span);
  for (int y = std::max(0, from.y); y <= std::min(grid.height() - 1, to.y); ++y) {
    for (int x = std::max(0, from.x); x <= std::min(grid.width() - 1, to.x); ++x) {
      const NavigationGrid::Cell cell{x, y};
      if (!walk.has(x, y)) continue;
      const Vec2 at = grid.center(cell);
      if (reach.beyond(at, limit)) continue;
      const double distance = reach(at);
      if (distance > limit || distance <= looked_m_) continue;
      double cost = distance;
      if (!target.movable && (at - middle).norm() > 1e-9) {
        cost += kFrontWeight_m * (1 - (at - middle).normalized().dot(front.head<2>()));
      }
      if (target.openable && !target.movable) {  // prefer positions in front, from which one can look inside
        const Vec3 local = to_target * Vec3(at.x(), at.y(), target.pose.position.z());
        const double aside = std::max(0.0, std::abs(local.x()) - target.size.x() / 2);
        cost += kAsideWeight * aside + (local.y() > -target.size.y() / 2 ? kAsideWeight : 0);
      }
      open_.push_back({cost, cell, at});
    }
  }
  std::make_heap(open_.begin(), open_.end(), std::greater<>());
  looked_m_ = limit;
}

bool StandingCells::Candidate::operator>(const Candidate& other) const {
  return std::tie(cost, cell.y, cell.x) > std::tie(other.cost, other.cell.y, other.cell.x);
}

const Vec2* StandingCells::best(std::size_t k, const StandingInputs& asked) {
  if (k < best_.size()) return &best_[k];
  const double limit_m = asked.profile.reach_m - kReachReserve_m;
  while (best_.size() <= k) {
    // The cost of a cell is at least its distance.
    while (looked_m_ < limit_m && (open_.empty() || open_.front().cost > looked_m_)) look_farther(asked, limit_m);
    if (open_.empty()) return nullptr;
    std::pop_heap(open_.begin(), open_.end(), std::greater<>());
    if (!within(way_, open_.back().at, asked.profile.body_radius_m)) best_.push_back(open_.back().at);
    open_.pop_back();
  }
  return &best_[k];
}

std::optional<Vec2> standing_place(const Scene& scene, const PhysicsWorld& world, std::size_t node,
                                   const StandingInputs& asked, StandingCells& cells) {
  for (std::size_t k = 0; k < kMostChecked; ++k) {
    const Vec2* at = cells.best(k, asked);
    if (at == nullptr) break;
    if (sees(scene, world, asked.profile, *at, node)) return *at;
  }
  return std::nullopt;
}

std::optional<Vec2> standing_place(const Scene& scene, const PhysicsWorld& world, const NavigationGrid& grid,
                                   const CellSet& walk_from_agent, const Profile& profile, std::size_t node) {
  const auto body = BodyId::node(node);
  const Shape shape = world.has(body) ? world.collider(body).shape : shape_of(scene.nodes[node]);
  StandingCells cells;
  return standing_place(scene, world, node, {scene.nodes[node], shape, grid, walk_from_agent, profile}, cells);
}

}  // namespace unietp
