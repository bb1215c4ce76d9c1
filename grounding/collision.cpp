#include "grounding/collision.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <unordered_map>
#include <vector>

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

/// A part in the world; FCL's form of it.
struct PlacedPart {
  BodyId id;
  Bounds bounds;
  fcl::CollisionObjectd object;

  PlacedPart(BodyId body, const Part& part, const Pose& in_world, const Bounds& tight, double gap)
      : id(body),
        bounds(tight),
        object(geometry_of(part, gap), in_world.rotation.normalized().toRotationMatrix(), in_world.position) {}
};

/// Which solids may be where, seen from above, by their tight bounds: FCL's own tree holds those of the sphere around
/// each turned object.
class PartGrid {
 public:
  void insert(const PlacedPart& solid) {
    each_cell(solid.bounds, [&](std::uint64_t cell) { cells_[cell].push_back(&solid); });
  }
  void erase(const PlacedPart& solid) {
    each_cell(solid.bounds, [&](std::uint64_t cell) { std::erase(cells_[cell], &solid); });
  }

  /// Each solid whose bounds overlap the given ones, in any order, once or more often.
  template <class Visit>
  void visit(const Bounds& bounds, const Visit& visit) const {
    each_cell(bounds, [&](std::uint64_t cell) {
      const auto found = cells_.find(cell);
      if (found == cells_.end()) return;
      for (const PlacedPart* solid : found->second) {
        if (overlap(solid->bounds, bounds)) visit(*solid);
      }
    });
  }

 private:
  static constexpr double kCell_m = 0.75;
  static constexpr double kFarthestCell = 1e6;  // what is farther away counts as there
  template <class Each>
  static void each_cell(const Bounds& bounds, const Each& each) {
    const auto cell = [](double m) {
      return static_cast<std::int32_t>(std::clamp(std::floor(m / kCell_m), -kFarthestCell, kFarthestCell));
    };
    for (std::int32_t y = cell(bounds.low.y()); y <= cell(bounds.high.y()); ++y) {
      for (std::int32_t x = cell(bounds.low.x()); x <= cell(bounds.high.x()); ++x)
        each((static_cast<std::uint64_t>(static_cast<std::uint32_t>(y)) << 32) | static_cast<std::uint32_t>(x));
    }
  }

  std::unordered_map<std::uint64_t, std::vector<const PlacedPart*>> cells_;  // never iterated
};

}  // namespace

struct PlacementChecker::Impl {
  std::unordered_map<BodyId, std::vector<std::unique_ptr<PlacedPart>>> bodies;  // never iterated
  PartGrid grid;
  std::shared_ptr<const PlacementChecker> below;
  std::set<BodyId> hidden;  // of `below`

  void remove(BodyId id) {
    const auto found = bodies.find(id);
    if (found == bodies.end()) return;
    for (const auto& solid : found->second) grid.erase(*solid);
    bodies.erase(found);
  }

  std::optional<BodyId> hit(const Shape& shape, const Pose& pose, double opening, double gap,
                            std::span<const BodyId> ignore, bool joints_only) const {
    std::optional<BodyId> lowest;
    for (const Part& part : shape.parts) {
      if (joints_only && part.joint < 0) continue;
      const Pose in_world = pose * joint_motion(shape, part.joint, opening) * part.pose;
      const Bounds bounds = bounds_of(in_world, part.size + Vec3::Constant(2 * gap));
      std::optional<PlacedPart> probe;  // made for the first that is near
      const auto test = [&](const PlacedPart& there) {
        if (lowest && *lowest <= there.id) return;
        if (std::find(ignore.begin(), ignore.end(), there.id) != ignore.end()) return;
        if (!probe) probe.emplace(BodyId(), part, in_world, bounds, gap);
        const fcl::CollisionRequestd request(1, false);
        fcl::CollisionResultd result;
        if (fcl::collide(&there.object, &probe->object, request, result) > 0) lowest = there.id;
      };
      grid.visit(bounds, test);
      if (!below) continue;
      below->impl_->grid.visit(bounds, [&](const PlacedPart& there) {
        if (!hidden.contains(there.id)) test(there);
      });
    }
    return lowest;
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
  return std::make_shared<const PlacementChecker>(std::move(checker));
}

void PlacementChecker::set(BodyId id, const Shape& shape, const Pose& pose, double opening) {
  remove(id);
  auto& solids = impl_->bodies[id];
  solids.reserve(shape.parts.size());
  for (const Part& part : shape.parts) {
    const Pose in_world = pose * joint_motion(shape, part.joint, opening) * part.pose;
    solids.push_back(std::make_unique<PlacedPart>(id, part, in_world, bounds_of(in_world, part.size), 0));
    impl_->grid.insert(*solids.back());
  }
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
  std::size_t wall = 0;
  for (const WallPiece& piece : walls_of(scene)) {
    Shape shape;
    shape.parts.push_back({Part::Kind::Box, {}, piece.size, -1});
    checker.set(BodyId::wall(wall++), shape, piece.pose, 0);
  }
}

}  // namespace unietp
