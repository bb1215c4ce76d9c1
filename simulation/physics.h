#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "scene/geometry.h"
#include "scene/room_finder.h"
#include "simulation/body_id.h"
#include "simulation/collider.h"
#include "simulation/settle.h"

namespace unietp {

/// A contact of a body with another one.
struct Contact {
  BodyId other;
  Vec3 normal = Vec3::UnitZ();  // from the other body to this one, W
  double gap = 0;               // meters, negative when they overlap
};

/// The first body that a ray meets.
struct RayHit {
  BodyId body;
  double fraction = 1;  // of the way from start to end
};

/// A body's pose after `settle`.
struct SettledBody {
  BodyId body;
  Pose pose;
};
/// Result of `settle`.
struct Settled {
  std::vector<SettledBody> bodies;  // the loose ones, in the order given
  bool calm = false;                // all came to rest within max_steps
  std::size_t work = 0;             // as SettleOptions::most_work counts it
};

/// All solids of a scene, for queries (contacts, overlaps, rays) and for letting objects come to rest. The world has
/// poses only: settling runs in a fresh small dynamics world (Bullet, double precision) around the loose bodies and
/// returns poses, so equal worlds give equal results. Floor: the plane z = 0. The cost of a query depends on the bodies
/// nearby, not on the size of the world; a copy costs a pointer per 256 bodies. Not thread-safe; one world per thread.
class PhysicsWorld {
 public:
  PhysicsWorld();
  PhysicsWorld(const PhysicsWorld&);
  PhysicsWorld(PhysicsWorld&&) noexcept;
  PhysicsWorld& operator=(const PhysicsWorld&);
  PhysicsWorld& operator=(PhysicsWorld&&) noexcept;
  ~PhysicsWorld();
  /// Computes in advance what queries need. Afterwards several threads may copy this world; the copies share what they
  /// do not change.
  void prepare();

  /// Adds a body or replaces it. `mass` > 0 for bodies that may ever be loose.
  void set(BodyId id, std::shared_ptr<const Collider> collider, const Pose& pose, double mass);
  void set(BodyId id, const Shape& shape, const Pose& pose, double opening, double mass);
  void move(BodyId id, const Pose& pose);
  void remove(BodyId id);
  /// Whether there is such a body.
  bool has(BodyId id) const;

  /// Sets the rooms of `floor()`.
  void divide_floor(const std::vector<Room>& rooms);
  /// Shared by copies.
  const RoomFinder& floor() const;

  /// What supports the body, or would if it sank by `gap`: every body that it then overlaps, the floor included;
  /// several contacts with one body are merged into the one whose normal points most upwards. In order of BodyId, floor
  /// last.
  std::vector<Contact> contacts(BodyId id, double gap) const;
  /// The collider of a body that the world has.
  const Collider& collider(BodyId id) const;
  std::shared_ptr<const Collider> share(BodyId id) const;
  /// The first body (lowest id) that a collider or shape at a pose would overlap by more than `depth` meters; `ignore`
  /// are left out.
  std::optional<BodyId> overlap(const Collider& collider, const Pose& pose, std::span<const BodyId> ignore,
                                double depth = 0.0) const;
  std::optional<BodyId> overlap(const Shape& shape, const Pose& pose, double opening, std::span<const BodyId> ignore,
                                double depth = 0.0) const;
  /// The nearest body that the segment meets.
  std::optional<RayHit> ray(const Vec3& from, const Vec3& to, std::span<const BodyId> ignore = {}) const;
  /// Bodies whose bounds come nearer than `gap` to the given bounds, in order of BodyId.
  std::vector<BodyId> near(const Bounds& bounds, double gap) const;
  /// Of a body that is there, W, meters.
  Bounds bounds(BodyId id) const;

  /// Lets the given bodies fall and slide until they rest, all others fixed. Does not change the world: apply the poses
  /// with `move`. Deterministic.
  Settled settle(std::span<const BodyId> loose, const SettleOptions& options = {}) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace unietp
