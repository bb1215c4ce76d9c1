#include "grounding/workspace.h"

#include <utility>

#include "simulation/relations.h"
#include "simulation/shape.h"
#include "simulation/walls.h"

namespace unietp {

std::optional<Bounds> sweep_of(const Node& node) {
  if (!node.openable) return std::nullopt;
  const Shape shape = shape_of(node);
  std::optional<Bounds> swept;
  for (const Part& part : shape.parts) {
    if (part.joint < 0) continue;
    for (int k = 0; k <= 4; ++k) {
      const Bounds one = bounds_of(node.pose * joint_motion(shape, part.joint, k / 4.0) * part.pose, part.size);
      if (!swept) swept = one;
      swept->low = swept->low.cwiseMin(one.low);
      swept->high = swept->high.cwiseMax(one.high);
    }
  }
  return swept;
}

bool allowed(const Knowledge& knowledge, const Node& object, Predicate relation, const Node& receptacle) {
  return knowledge.placement(object.category, relation == Predicate::Inside ? "inside" : "on", receptacle.category) !=
         nullptr;
}

Workspace::Workspace(Scene scene, const Knowledge& knowledge) : scene_(std::move(scene)), knowledge_(&knowledge) {
  rebuild();
}

void Workspace::rebuild() {
  physics_ = physics_of(scene_);
  checker_ = PlacementChecker();
  sweeps_.clear();
  bounds_.clear();
  BodyId wall = kFirstWall;
  for (const WallPiece& piece : walls_of(scene_)) {
    Shape shape;
    shape.parts.push_back({Part::Kind::Box, {}, piece.size, -1});
    checker_.set(wall++, shape, piece.pose, 0);
  }
  for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
    const Node& node = scene_.nodes[i];
    const Shape shape = shape_of(node);
    checker_.set(static_cast<BodyId>(i), shape, node.pose, node.opening);
    bounds_.push_back(bounds_of(shape, node.pose, node.opening));
    sweeps_.push_back(node.movable ? std::nullopt : sweep_of(node));
  }
}

std::size_t Workspace::add(Node node) {
  const std::size_t index = scene_.nodes.size();
  scene_.nodes.emplace_back();
  sweeps_.emplace_back();
  bounds_.emplace_back();
  replace(index, std::move(node));
  return index;
}

void Workspace::replace(std::size_t index, Node node) {
  const Shape shape = shape_of(node);
  const auto body = static_cast<BodyId>(index);
  physics_.set(body, shape, node.pose, node.opening, node.mass);
  checker_.set(body, shape, node.pose, node.opening);
  bounds_[index] = bounds_of(shape, node.pose, node.opening);
  sweeps_[index] = node.movable ? std::nullopt : sweep_of(node);
  scene_.nodes[index] = std::move(node);
}

void Workspace::remove(std::size_t index) {
  scene_.nodes.erase(scene_.nodes.begin() + static_cast<std::ptrdiff_t>(index));
  rebuild();
}

void Workspace::read_edges() { scene_.edges = read_relations(scene_, physics_); }

std::string Workspace::name_of(BodyId body) const {
  if (body < scene_.nodes.size()) return scene_.nodes[body].id;
  return body >= kFloor ? "the floor" : "a wall";
}

}  // namespace unietp
