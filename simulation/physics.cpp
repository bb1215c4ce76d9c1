#include "simulation/physics.h"

#include <algorithm>
#include <map>

#include <btBulletDynamicsCommon.h>

namespace unietp {
namespace {

constexpr double kMargin_m = 0.001;  // Bullet's default of 40 mm would round off everything in a kitchen
constexpr double kFriction = 0.7;
constexpr double kRollingFriction = 0.02;
constexpr double kGravity_m_s2 = 9.81;

btVector3 to_bullet(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
btTransform to_bullet(const Pose& pose) {
  const Quat& q = pose.rotation;
  return btTransform(btQuaternion(q.x(), q.y(), q.z(), q.w()), to_bullet(pose.position));
}
Vec3 from_bullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
Pose from_bullet(const btTransform& t) {
  const btQuaternion q = t.getRotation();
  return {from_bullet(t.getOrigin()), Quat(q.w(), q.x(), q.y(), q.z()).normalized()};
}

/// A compound with its children, built from a shape at one joint position.
struct Solid {
  std::vector<std::unique_ptr<btCollisionShape>> children;
  btCompoundShape compound;
  bool rolls = false;

  Solid(const Shape& shape, double opening) : compound(true, static_cast<int>(shape.parts.size())) {
    for (const Part& part : shape.parts) {
      const btVector3 half = to_bullet(part.size / 2);
      std::unique_ptr<btCollisionShape> child;
      switch (part.kind) {
        case Part::Kind::Box:
          child = std::make_unique<btBoxShape>(half);
          break;
        case Part::Kind::Cylinder:
          child = std::make_unique<btCylinderShapeZ>(half);
          break;
        case Part::Kind::Sphere:
          child = std::make_unique<btSphereShape>(half.x());
          break;
      }
      if (part.kind != Part::Kind::Sphere) child->setMargin(kMargin_m);
      if (part.kind != Part::Kind::Box) rolls = true;
      compound.addChildShape(to_bullet(joint_motion(shape, part.joint, opening) * part.pose), child.get());
      children.push_back(std::move(child));
    }
    compound.setMargin(kMargin_m);
  }
};

struct Body {
  std::shared_ptr<Solid> solid;  // shared by the copies of a world: it never changes once built
  Pose pose;
  double mass = 0;
  Bounds bounds;
};

Bounds solid_bounds(const btCollisionShape& shape, const Pose& pose) {
  btVector3 low, high;
  shape.getAabb(to_bullet(pose), low, high);
  return {from_bullet(low), from_bullet(high)};
}

BodyId id_of(const btCollisionObject* object) { return static_cast<BodyId>(object->getUserIndex()); }

/// Worlds are small and many: Bullet's default pools of 4096 entries would cost more than the work itself.
btDefaultCollisionConstructionInfo small_pools() {
  btDefaultCollisionConstructionInfo pools;
  pools.m_defaultMaxPersistentManifoldPoolSize = 256;
  pools.m_defaultMaxCollisionAlgorithmPoolSize = 256;
  return pools;
}

/// Bullet's machinery for questions about fixed poses.
struct Questions {
  btDefaultCollisionConfiguration configuration{small_pools()};
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btCollisionWorld world{&dispatcher, &broadphase, &configuration};
  std::map<BodyId, std::unique_ptr<btCollisionObject>> objects;

  Questions() { world.setForceUpdateAllAabbs(false); }
  ~Questions() {
    for (auto& [id, object] : objects) world.removeCollisionObject(object.get());
  }
  Questions(const Questions&) = delete;
  Questions& operator=(const Questions&) = delete;

  void add(BodyId id, const Body& body) {
    auto object = std::make_unique<btCollisionObject>();
    object->setCollisionShape(&body.solid->compound);
    object->setWorldTransform(to_bullet(body.pose));
    object->setUserIndex(static_cast<int>(id));
    world.addCollisionObject(object.get());
    objects[id] = std::move(object);
  }
  void remove(BodyId id) {
    const auto found = objects.find(id);
    if (found == objects.end()) return;
    world.removeCollisionObject(found->second.get());
    objects.erase(found);
  }
};

/// Collects for each other body the contact whose normal points most upwards.
struct ContactCollector : btCollisionWorld::ContactResultCallback {
  const btCollisionObject* self;
  double deepest_ignored;  // overlaps shallower than this do not count
  std::map<BodyId, Contact> found;

  ContactCollector(const btCollisionObject* self_object, double depth) : self(self_object), deepest_ignored(depth) {}

  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper* a, int, int,
                           const btCollisionObjectWrapper* b, int, int) override {
    if (point.getDistance() > -deepest_ignored) return 0;
    const bool self_is_a = a->getCollisionObject() == self;
    const btCollisionObject* other = self_is_a ? b->getCollisionObject() : a->getCollisionObject();
    Vec3 normal = from_bullet(point.m_normalWorldOnB);
    if (!self_is_a) normal = -normal;
    const Contact contact{id_of(other), normal, point.getDistance()};
    const auto [at, fresh] = found.try_emplace(contact.other, contact);
    if (!fresh && normal.z() > at->second.normal.z()) at->second = contact;
    return 0;
  }
};

struct NearestHit : btCollisionWorld::ClosestRayResultCallback {
  std::span<const BodyId> ignore;
  NearestHit(const btVector3& from, const btVector3& to, std::span<const BodyId> ignored)
      : ClosestRayResultCallback(from, to), ignore(ignored) {}
  bool needsCollision(btBroadphaseProxy* proxy) const override {
    const BodyId id = id_of(static_cast<const btCollisionObject*>(proxy->m_clientObject));
    return std::find(ignore.begin(), ignore.end(), id) == ignore.end();
  }
};

}  // namespace

struct PhysicsWorld::Impl {
  std::map<BodyId, Body> bodies;
  mutable std::unique_ptr<Questions> questions;  // built at the first question

  Questions& ask() const {
    if (!questions) {
      questions = std::make_unique<Questions>();
      for (const auto& [id, body] : bodies) questions->add(id, body);
    }
    return *questions;
  }
};

PhysicsWorld::PhysicsWorld() : impl_(std::make_unique<Impl>()) {}
PhysicsWorld::PhysicsWorld(const PhysicsWorld& other) : impl_(std::make_unique<Impl>()) {
  impl_->bodies = other.impl_->bodies;
}
PhysicsWorld::PhysicsWorld(PhysicsWorld&&) noexcept = default;
PhysicsWorld& PhysicsWorld::operator=(const PhysicsWorld& other) {
  if (this != &other) *this = PhysicsWorld(other);
  return *this;
}
PhysicsWorld& PhysicsWorld::operator=(PhysicsWorld&&) noexcept = default;
PhysicsWorld::~PhysicsWorld() = default;

void PhysicsWorld::set(BodyId id, const Shape& shape, const Pose& pose, double opening, double mass) {
  if (impl_->questions) impl_->questions->remove(id);
  auto solid = std::make_shared<Solid>(shape, opening);
  const Bounds bounds = solid_bounds(solid->compound, pose);
  Body& body = impl_->bodies[id] = {std::move(solid), pose, mass, bounds};
  if (impl_->questions) impl_->questions->add(id, body);
}

void PhysicsWorld::move(BodyId id, const Pose& pose) {
  Body& body = impl_->bodies.at(id);
  body.pose = pose;
  body.bounds = solid_bounds(body.solid->compound, pose);
  if (impl_->questions) {
    btCollisionObject* object = impl_->questions->objects.at(id).get();
    object->setWorldTransform(to_bullet(pose));
    impl_->questions->world.updateSingleAabb(object);
  }
}

void PhysicsWorld::remove(BodyId id) {
  if (impl_->questions) impl_->questions->remove(id);
  impl_->bodies.erase(id);
}

bool PhysicsWorld::has(BodyId id) const { return impl_->bodies.contains(id); }

Bounds PhysicsWorld::bounds(BodyId id) const { return impl_->bodies.at(id).bounds; }

std::vector<Contact> PhysicsWorld::contacts(BodyId id, double gap) const {
  const Body& body = impl_->bodies.at(id);
  btCollisionObject probe;
  probe.setCollisionShape(&body.solid->compound);
  probe.setWorldTransform(to_bullet(Pose{body.pose.position - Vec3(0, 0, gap), body.pose.rotation}));
  ContactCollector collector(&probe, 0.0);
  impl_->ask().world.contactTest(&probe, collector);
  std::vector<Contact> all;
  for (auto& [other, contact] : collector.found) {
    if (other == id) continue;
    contact.gap += gap;
    all.push_back(contact);
  }
  const double above_floor = body.bounds.low.z();
  if (above_floor < gap) all.push_back({kFloor, Vec3::UnitZ(), above_floor});
  return all;
}

std::optional<BodyId> PhysicsWorld::overlap(const Shape& shape, const Pose& pose, double opening,
                                            std::span<const BodyId> ignore, double depth) const {
  Solid solid(shape, opening);
  btCollisionObject probe;
  probe.setCollisionShape(&solid.compound);
  probe.setWorldTransform(to_bullet(pose));
  ContactCollector collector(&probe, depth);
  impl_->ask().world.contactTest(&probe, collector);
  for (const auto& [other, contact] : collector.found) {
    if (std::find(ignore.begin(), ignore.end(), other) == ignore.end()) return other;
  }
  if (solid_bounds(solid.compound, pose).low.z() < -depth) return kFloor;
  return std::nullopt;
}

std::optional<RayHit> PhysicsWorld::ray(const Vec3& from, const Vec3& to, std::span<const BodyId> ignore) const {
  const btVector3 start = to_bullet(from), end = to_bullet(to);
  NearestHit hit(start, end, ignore);
  impl_->ask().world.rayTest(start, end, hit);
  if (!hit.hasHit()) return std::nullopt;
  return RayHit{id_of(hit.m_collisionObject), hit.m_closestHitFraction};
}

std::vector<BodyId> PhysicsWorld::near(const Bounds& bounds, double gap) const {
  std::vector<BodyId> ids;
  for (const auto& [id, body] : impl_->bodies) {
    if (unietp::overlap(body.bounds, bounds, gap)) ids.push_back(id);
  }
  return ids;
}

namespace {

/// A small dynamics world that owns what it steps.
struct Dynamics {
  btDefaultCollisionConfiguration configuration{small_pools()};
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
  btStaticPlaneShape floor_shape{btVector3(0, 0, 1), 0};
  std::vector<std::unique_ptr<btRigidBody>> bodies;

  Dynamics() {
    world.getDispatchInfo().m_deterministicOverlappingPairs = true;
    world.setForceUpdateAllAabbs(false);
    world.setGravity({0, 0, -kGravity_m_s2});
    add(&floor_shape, Pose{}, 0, false);
  }
  ~Dynamics() {
    for (auto& body : bodies) world.removeRigidBody(body.get());
  }
  Dynamics(const Dynamics&) = delete;
  Dynamics& operator=(const Dynamics&) = delete;

  btRigidBody& add(btCollisionShape* shape, const Pose& pose, double mass, bool rolls) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0) shape->calculateLocalInertia(mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape, inertia);
    info.m_startWorldTransform = to_bullet(pose);
    info.m_friction = kFriction;
    info.m_rollingFriction = rolls ? kRollingFriction : 0;
    info.m_spinningFriction = rolls ? kRollingFriction : 0;
    info.m_linearDamping = 0.04;
    info.m_angularDamping = 0.1;
    auto body = std::make_unique<btRigidBody>(info);
    body->setActivationState(DISABLE_DEACTIVATION);
    world.addRigidBody(body.get());
    bodies.push_back(std::move(body));
    return *bodies.back();
  }
};

Bounds merged(const Bounds& a, const Bounds& b) { return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)}; }

}  // namespace

Settled PhysicsWorld::settle(std::span<const BodyId> loose, const SettleOptions& options) const {
  if (loose.empty()) return {{}, true};
  Dynamics dynamics;

  const auto is_loose = [&](BodyId id) { return std::find(loose.begin(), loose.end(), id) != loose.end(); };
  Bounds region = impl_->bodies.at(loose.front()).bounds;
  for (const BodyId id : loose) region = merged(region, impl_->bodies.at(id).bounds);
  region.low.z() = -1;  // whatever lies below can be fallen on
  for (const auto& [id, body] : impl_->bodies) {
    if (!is_loose(id) && unietp::overlap(body.bounds, region, options.surroundings_m)) {
      dynamics.add(&body.solid->compound, body.pose, 0, body.solid->rolls);
    }
  }
  std::vector<btRigidBody*> moving;
  for (const BodyId id : loose) {
    const Body& body = impl_->bodies.at(id);
    moving.push_back(&dynamics.add(&body.solid->compound, body.pose, std::max(body.mass, 0.01), body.solid->rolls));
  }

  int calm_for = 0;
  for (int step = 0; step < options.max_steps && calm_for < options.calm_steps; ++step) {
    dynamics.world.stepSimulation(options.step_s, 0, options.step_s);
    const bool calm = std::all_of(moving.begin(), moving.end(), [&](const btRigidBody* body) {
      return body->getLinearVelocity().length() < options.calm_m_s &&
             body->getAngularVelocity().length() < options.calm_rad_s;
    });
    calm_for = calm ? calm_for + 1 : 0;
  }
  Settled settled;
  settled.calm = calm_for >= options.calm_steps;
  for (std::size_t i = 0; i < moving.size(); ++i) {
    settled.bodies.push_back({loose[i], from_bullet(moving[i]->getWorldTransform())});
  }
  return settled;
}

}  // namespace unietp
