#include "simulation/solids.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <string_view>

#include "simulation/relations.h"
#include "simulation/shape.h"
#include "simulation/state_solids.h"
#include "simulation/walls.h"

namespace unietp {
namespace {

/// Whether a node is drawn round: nearly square from above and without boards.
bool is_round(const Node& node) {
  constexpr double kLeast = 0.7;
  if (!node.boards.empty() || (node.archetype != Archetype::Plate && node.archetype != Archetype::Vessel)) return false;
  constexpr double kLargest_m = 0.5;  // larger ones are baskets and crates
  const auto [least, most] = std::minmax(node.size.x(), node.size.y());
  return least > kLeast * most && most < kLargest_m;
}

/// A disc, or a floor with a ring of boxes around it.
std::vector<Part> round_parts(const Node& node) {
  const double radius = std::min(node.size.x(), node.size.y()) / 2, height = node.size.z();
  const auto disc = [&](double low, double high, double wide) {
    return Part{Part::Kind::Cylinder,
                {Vec3(0, 0, (low + high) / 2), Quat::Identity()},
                Vec3(2 * wide, 2 * wide, high - low),
                -1};
  };
  if (node.archetype == Archetype::Plate) return {disc(-height / 2, height / 2, radius)};
  constexpr int kStaves = 12;
  const double wall = std::clamp(0.07 * node.size.minCoeff(), 0.003, 0.012);
  std::vector<Part> parts{disc(-height / 2, -height / 2 + wall, radius)};
  const double middle = radius - wall / 2;
  for (int i = 0; i < kStaves; ++i) {
    const double angle = 2 * std::numbers::pi * i / kStaves;
    const Quat turn(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
    const double wide = 2 * radius * std::tan(std::numbers::pi / kStaves);
    parts.push_back({Part::Kind::Box, {turn * Vec3(middle, 0, 0), turn}, Vec3(wall, wide, height), -1});
  }
  return parts;
}

}  // namespace

std::vector<std::size_t> hidden_from_sight(const Scene& scene) {
  std::vector<std::string_view> closed;
  for (const Node& node : scene.nodes) {
    if (node.openable && !node.states.has(Predicate::Open)) closed.push_back(node.id);
  }
  std::sort(closed.begin(), closed.end());
  std::set<std::string_view> hidden;
  for (const Edge& edge : scene.edges) {
    if (edge.relation == Predicate::Inside && std::binary_search(closed.begin(), closed.end(), edge.to))
      hidden.insert(edge.from);
  }
  std::vector<std::string> in_hand = scene.agent.held;
  for (const std::string& id : scene.agent.held) {
    const auto carried = carried_by(scene, id);
    in_hand.insert(in_hand.end(), carried.begin(), carried.end());
  }
  hidden.insert(in_hand.begin(), in_hand.end());
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (hidden.contains(scene.nodes[i].id)) places.push_back(i);
  }
  return places;
}

double sight_radius(const Node& node) {
  return node.opening > 0 ? node.size.norm() : node.size.norm() / 2;  // an open door may be as wide as the body
}

void add_solids(const Node& node, std::int32_t owner, std::vector<Solid>& solids) {
  const Shape shape = shape_of(node);
  for (const Part& part : shape.parts) {
    const Pose pose = node.pose * (joint_motion(shape, part.joint, node.opening) * part.pose);
    solids.push_back({part.kind, pose, part.size, owner, part.joint >= 0});
  }
}

void add_shown(const Node& node, std::int32_t owner, std::vector<Solid>& solids) {
  const bool round = is_round(node);
  if (round) {
    for (const Part& part : round_parts(node)) solids.push_back({part.kind, node.pose * part.pose, part.size, owner});
  } else {
    add_solids(node, owner, solids);
  }
  add_state_solids(node, owner, round, solids);
}

std::vector<Solid> solids_of(const Scene& scene, const Camera& camera, double farthest,
                             const std::vector<std::size_t>& hidden, bool rounded) {
  std::vector<Solid> solids;
  const auto matters = [&](const Vec3& centre, double radius) {
    return (centre - camera.at).norm() - radius <= farthest && camera.may_show(centre, radius);
  };
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    if (!matters(node.pose.position, sight_radius(node))) continue;
    if (std::binary_search(hidden.begin(), hidden.end(), i)) continue;
    const auto owner = static_cast<std::int32_t>(i);
    rounded ? add_shown(node, owner, solids) : add_solids(node, owner, solids);
  }
  for (const WallPiece& piece : walls_of(scene)) {
    if (matters(piece.pose.position, piece.size.norm() / 2))
      solids.push_back({Part::Kind::Box, piece.pose, piece.size, -1, false});
  }
  return solids;
}

}  // namespace unietp
