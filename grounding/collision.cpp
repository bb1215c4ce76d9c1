#include "grounding/collision.h"

#include <algorithm>
#include <map>
#include <vector>

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/collision_object.h>

namespace unietp {
namespace {

using Object = std::unique_ptr<fcl::CollisionObjectd>;

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

Object object_of(const Part& part, const Pose& pose, double gap) {
  const Pose in_world = pose * part.pose;
  return std::make_unique<fcl::CollisionObjectd>(geometry_of(part, gap),
                                                 in_world.rotation.normalized().toRotationMatrix(), in_world.position);
}

struct Query {
  std::span<const BodyId> ignore;
  std::optional<BodyId> lowest;
};

BodyId id_of(const fcl::CollisionObjectd& object) {
  return static_cast<BodyId>(reinterpret_cast<std::uintptr_t>(object.getUserData()));
}

/// Broad-phase callback: `first` is one of the stored bodies or the probe, which has no user data to speak of.
bool test_pair(fcl::CollisionObjectd* stored, fcl::CollisionObjectd* probe, void* data) {
  auto& query = *static_cast<Query*>(data);
  const BodyId id = id_of(*stored);
  if (query.lowest && *query.lowest <= id) return false;
  if (std::find(query.ignore.begin(), query.ignore.end(), id) != query.ignore.end()) return false;
  const fcl::CollisionRequestd request(1, false);
  fcl::CollisionResultd result;
  if (fcl::collide(stored, probe, request, result) > 0) query.lowest = id;
  return false;  // go on: the lowest id is wanted, not the first found
}

}  // namespace

struct PlacementChecker::Impl {
  std::map<BodyId, std::vector<Object>> bodies;
  fcl::DynamicAABBTreeCollisionManagerd tree;

  void remove(BodyId id) {
    const auto found = bodies.find(id);
    if (found == bodies.end()) return;
    for (const Object& object : found->second) tree.unregisterObject(object.get());
    bodies.erase(found);
  }

  std::optional<BodyId> hit(const Shape& shape, const Pose& pose, double opening, double gap,
                            std::span<const BodyId> ignore, bool joints_only) {
    Query query{ignore, std::nullopt};
    for (const Part& part : shape.parts) {
      if (joints_only && part.joint < 0) continue;
      const Object probe = object_of(part, pose * joint_motion(shape, part.joint, opening), gap);
      // The manager calls back with (stored, query object).
      tree.collide(probe.get(), &query, test_pair);
    }
    return query.lowest;
  }
};

PlacementChecker::PlacementChecker() : impl_(std::make_unique<Impl>()) {}
PlacementChecker::PlacementChecker(PlacementChecker&&) noexcept = default;
PlacementChecker& PlacementChecker::operator=(PlacementChecker&&) noexcept = default;
PlacementChecker::~PlacementChecker() = default;

void PlacementChecker::set(BodyId id, const Shape& shape, const Pose& pose, double opening) {
  impl_->remove(id);
  auto& objects = impl_->bodies[id];
  for (const Part& part : shape.parts) {
    objects.push_back(object_of(part, pose * joint_motion(shape, part.joint, opening), 0));
    objects.back()->setUserData(reinterpret_cast<void*>(static_cast<std::uintptr_t>(id)));
    impl_->tree.registerObject(objects.back().get());
  }
  impl_->tree.setup();
}

void PlacementChecker::remove(BodyId id) {
  impl_->remove(id);
  impl_->tree.setup();
}

std::optional<BodyId> PlacementChecker::hit(const Shape& shape, const Pose& pose, double opening, double gap,
                                            std::span<const BodyId> ignore) const {
  return impl_->hit(shape, pose, opening, std::max(gap, 1e-3), ignore, false);
}

std::optional<BodyId> PlacementChecker::hit_by_joints(const Shape& shape, const Pose& pose, double opening, double gap,
                                                      std::span<const BodyId> ignore) const {
  return impl_->hit(shape, pose, opening, std::max(gap, 1e-3), ignore, true);
}

}  // namespace unietp
