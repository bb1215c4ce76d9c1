#include "simulation/solids.h"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include "scene/archetype_dimensions.h"
#include "shapes/library.h"
#include "simulation/finish.h"
#include "simulation/noise.h"
#include "simulation/relations.h"
#include "simulation/shape.h"
#include "simulation/state_solids.h"

namespace unietp {
namespace {

void add_piece(const Piece& piece, const Node& node, std::int32_t owner, std::vector<Solid>& solids) {
  const Eigen::Matrix3d to_w = node.pose.rotation.toRotationMatrix() * (node.size / 2).asDiagonal();
  const bool straight = piece.low == Vec2::Ones() && piece.high == Vec2::Ones();
  Solid solid;
  switch (piece.kind) {
    case PieceKind::Block:
      solid.kind = straight ? SolidKind::Box : SolidKind::Wedge;
      break;
    case PieceKind::Drum:
      solid.kind = straight ? SolidKind::Cylinder : SolidKind::Cone;
      break;
    case PieceKind::Ball:
      solid.kind = SolidKind::Sphere;
      break;
    case PieceKind::Cup:
      solid.kind = SolidKind::Cup;
      break;
    case PieceKind::Crate:
      solid.kind = SolidKind::Crate;
      break;
  }
  solid.pose = {node.pose.position + to_w * piece.center, node.pose.rotation};
  solid.size = piece.axes.cwiseAbs().rowwise().sum().cwiseProduct(node.size);
  solid.owner = owner;
  solid.sheared = true;
  solid.axes = to_w * piece.axes;
  solid.low = piece.low;
  solid.high = piece.high;
  solid.wall = piece.wall;
  solid.floor = piece.floor;
  solid.color = piece.color;
  solid.shade = piece.shade;
  solid.matter = piece.matter;
  solid.screen = piece.screen;
  solids.push_back(solid);
}

void add_archetype(const Node& node, std::int32_t owner, std::vector<Solid>& solids) {
  const Shape shape = shape_of(node);
  for (const Part& part : shape.parts) {
    const Pose pose = node.pose * (joint_motion(shape, part.joint, node.opening) * part.pose);
    solids.push_back({kind_of(part.kind), pose, part.size, owner, part.joint >= 0});
    if (part.joint < 0) continue;
    if (node.archetype == Archetype::Cabinet) solids.back().handle = part.joint == 0 ? 1 : -1;  // away from the hinge
    if (node.archetype == Archetype::Drawers) solids.back().handle = 2;
  }
}

/// Whether what is behind a thing's glass is seen: not through frost, nor through the glass of a window, a lamp or
/// another device, which show something else.
bool seen_through(const Node& node) {
  const StateSet& states = node.states;
  return !states.has(Predicate::Frozen) && !states.has(Predicate::PowerOn) && !states.has(Predicate::PowerOff) &&
         !is_window(node);
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
  const double body = node.opening > 0 ? node.size.norm() : node.size.norm() / 2;  // a door may be as wide as the body
  double out = 0;  // how far boards stand out of the box
  for (const Board& board : node.boards) {
    const Vec3 beyond = board.center.cwiseAbs() + board.size / 2 - node.size / 2;
    out = std::max(out, beyond.cwiseMax(0).norm());
  }
  return body + out + reach_of_states(node);
}

const ShapeFamily* family_of(const Node& node, Simulator simulator) {
  if (!node.boards.empty()) return nullptr;
  return built_in_shapes().family_of(simulator, node.category, node.archetype);
}

void add_solids(const Node& node, std::int32_t owner, Simulator simulator, std::span<const WallPiece> walls,
                std::vector<Solid>& solids) {
  const ShapeFamily* family = family_of(node, simulator);
  const std::size_t first = solids.size();
  if (family != nullptr) {  // first, since of two equally near solids the first is seen
    for (const Piece& piece : pieces_of(*family, {node.size, vessel_wall(node.size), number_of(node.id), node.states}))
      add_piece(piece, node, owner, solids);
  }
  if (family == nullptr || family->keeps_body) add_archetype(node, owner, solids);
  if (seen_through(node)) {
    const Matter own = matter_of(node, family);
    for (std::size_t i = first; i < solids.size(); ++i)
      solids[i].clear = !solids[i].screen && solids[i].matter.value_or(own) == Matter::Glass;
  }
  add_state_solids(node, owner, first, family != nullptr && family->shows_open, walls, solids);
}

std::vector<Solid> solids_of(const Scene& scene, const Camera& camera, double farthest,
                             const std::vector<std::size_t>& hidden) {
  std::vector<Solid> solids;
  const std::vector<WallPiece> walls = walls_of(scene);
  const auto matters = [&](const Vec3& center, double radius) {
    return (center - camera.at).norm() - radius <= farthest && camera.may_show(center, radius);
  };
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    if (!matters(node.pose.position, sight_radius(node))) continue;
    if (std::binary_search(hidden.begin(), hidden.end(), i)) continue;
    add_solids(node, static_cast<std::int32_t>(i), scene.simulator, walls, solids);
  }
  for (const WallPiece& piece : walls) {
    if (matters(piece.pose.position, piece.size.norm() / 2))
      solids.push_back({SolidKind::Box, piece.pose, piece.size, -1, false});
  }
  return solids;
}

}  // namespace unietp
