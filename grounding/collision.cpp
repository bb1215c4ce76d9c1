#include "grounding/collision.h"

#include <algorithm>
#include <set>
#include <unordered_map>
#include <vector>

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/collision_object.h>

#include "simulation/walls.h"

namespace unietp {
namespace {

std::shared_ptr<fcl::CollisionGeometryd> geometry_of(const Part& part, double gap) {
  const Vec3 size = part.size + Vec3::Constant(2 * gap);
  switch (part.kind) {
    case Part::Kind::Sphere:
      return std::make_shared<fcl::Sphered>(size.maxCoeff() / 2);
    case Part::Kind::Cylinder:
      return std::make_shared<fcl::Cylinderd>(std::max(size.x(), size.y()) / 2, size.z());
    case Part::Kind::Box:
      break;
  }
  return std::make_shared<fcl::Boxd>(size);
}

/// A part in the world. FCL's own bounds of a turned object are those of the sphere around it; `bounds` are tight.
struct Solid {
  BodyId id = 0;
  Bounds bounds;
  fcl::CollisionObjectd object;

  Solid(BodyId body, const Part& part, const Pose& in_world, double gap)
      : id(body),
        bounds(bounds_of(in_world, part.size + Vec3::Constant(2 * gap))),
        object(geometry_of(part, gap), in_world.rotation.normalized().toRotationMatrix(), in_world.position) {
    object.setUserData(this);
  }
  Solid(const Solid&) = delete;
  Solid& operator=(const Solid&) = delete;
};

struct Query {
  std::span<const BodyId> ignore;
  const std::set<BodyId>* hidden;  // bodies of this tree that another lies over
  std::optional<BodyId> lowest;
};

/// Broad-phase callback: the manager calls back with (stored, query object).
bool test_pair(fcl::CollisionObjectd* stored, fcl::CollisionObjectd* probe, void* data) {
  auto& query = *static_cast<Query*>(data);
  const Solid& there = *static_cast<const Solid*>(stored->getUserData());
  if (query.lowest && *query.lowest <= there.id) return false;
  if (!overlap(there.bounds, static_cast<const Solid*>(probe->getUserData())->bounds)) return false;
  if (std::find(query.ignore.begin(), query.ignore.end(), there.id) != query.ignore.end()) return false;
  if (query.hidden->contains(there.id)) return false;
  const fcl::CollisionRequestd request(1, false);
  fcl::CollisionResultd result;
  if (fcl::collide(stored, probe, request, result) > 0) query.lowest = there.id;
  return false;  // go on: the lowest id is wanted, not the first found
}

}  // namespace

struct PlacementChecker::Impl {
  std::unordered_map<BodyId, std::vector<std::unique_ptr<Solid>>> bodies;  // never iterated
  fcl::DynamicAABBTreeCollisionManagerd tree;
  bool balanced = true;
  std::shared_ptr<const PlacementChecker> below;
  std::set<BodyId> hidden;  // of `below`

  void remove(BodyId id) {
    const auto found = bodies.find(id);
    if (found == bodies.end()) return;
    for (const auto& solid : found->second) tree.unregisterObject(&solid->object);
    bodies.erase(found);
    balanced = false;
  }

  /// Balancing looks at the whole tree, so it is done for the next question and not for each body that is added.
  void balance() {
    if (!balanced) tree.setup();
    balanced = true;
  }

  std::optional<BodyId> hit(const Shape& shape, const Pose& pose, double opening, double gap,
                            std::span<const BodyId> ignore, bool joints_only) {
    balance();
    static const std::set<BodyId> kNone;
    Query query{ignore, &kNone, std::nullopt};
    for (const Part& part : shape.parts) {
      if (joints_only && part.joint < 0) continue;
      Solid probe(0, part, pose * joint_motion(shape, part.joint, opening) * part.pose, gap);
      query.hidden = &kNone;
      tree.collide(&probe.object, &query, test_pair);
      if (!below) continue;
      query.hidden = &hidden;
      below->impl_->tree.collide(&probe.object, &query, test_pair);
    }
    return query.lowest;
  }
};

PlacementChecker::PlacementChecker() : impl_(std::make_unique<Impl>()) {}
PlacementChecker::PlacementChecker(std::shared_ptr<const PlacementChecker> below) : PlacementChecker() {
  impl_->below = std::move(below);
}
PlacementChecker::PlacementChecker(PlacementChecker&&) noexcept = default;
PlacementChecker& PlacementChecker::operator=(PlacementChecker&&) noexcept = default;
PlacementChecker::~PlacementChecker() = default;

std::shared_ptr<const PlacementChecker> PlacementChecker::shared(PlacementChecker checker) {
  checker.impl_->balance();
  return std::make_shared<const PlacementChecker>(std::move(checker));
}

void PlacementChecker::set(BodyId id, const Shape& shape, const Pose& pose, double opening) {
  remove(id);
  auto& solids = impl_->bodies[id];
  solids.reserve(shape.parts.size());
  for (const Part& part : shape.parts) {
    solids.push_back(std::make_unique<Solid>(id, part, pose * joint_motion(shape, part.joint, opening) * part.pose, 0));
    impl_->tree.registerObject(&solids.back()->object);
  }
  impl_->balanced = false;
}

void PlacementChecker::remove(BodyId id) {
  impl_->remove(id);
  if (impl_->below) impl_->hidden.insert(id);
}

std::optional<BodyId> PlacementChecker::hit(const Shape& shape, const Pose& pose, double opening, double gap,
                                            std::span<const BodyId> ignore) const {
  return impl_->hit(shape, pose, opening, std::max(gap, 1e-3), ignore, false);
}

std::optional<BodyId> PlacementChecker::hit_by_joints(const Shape& shape, const Pose& pose, double opening, double gap,
                                                      std::span<const BodyId> ignore) const {
  return impl_->hit(shape, pose, opening, std::max(gap, 1e-3), ignore, true);
}

void set_walls(PlacementChecker& checker, const Scene& scene) {
  BodyId wall = kFirstWall;
  for (const WallPiece& piece : walls_of(scene)) {
    Shape shape;
    shape.parts.push_back({Part::Kind::Box, {}, piece.size, -1});
    checker.set(wall++, shape, piece.pose, 0);
  }
}

}  // namespace unietp
