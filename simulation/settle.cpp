#include "simulation/settle.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <numbers>

#include <btBulletDynamicsCommon.h>

namespace unietp {
namespace {

constexpr double kFriction = 0.7;
constexpr double kRollingFriction = 0.02;
constexpr double kGravity_m_s2 = 9.81;

btVector3 to_bullet(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
btTransform to_bullet(const Pose& pose) {
  const Quat& q = pose.rotation;
  return btTransform(btQuaternion(q.x(), q.y(), q.z(), q.w()), to_bullet(pose.position));
}
Pose from_bullet(const btTransform& t) {
  const btQuaternion q = t.getRotation();
  const btVector3& at = t.getOrigin();
  return {Vec3(at.x(), at.y(), at.z()), Quat(q.w(), q.x(), q.y(), q.z()).normalized()};
}
btTransform to_bullet(const Convex& part) {
  const auto& m = part.axes;
  return btTransform(btMatrix3x3(m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)),
                     to_bullet(part.center));
}

/// Small memory pools: allocating Bullet's default pools of 4096 entries would take longer than the simulation.
btDefaultCollisionConstructionInfo small_pools() {
  btDefaultCollisionConstructionInfo pools;
  pools.m_defaultMaxPersistentManifoldPoolSize = 32;
  pools.m_defaultMaxCollisionAlgorithmPoolSize = 64;
  return pools;
}

/// A small dynamics world that owns its bodies.
class Dynamics {
 public:
  Dynamics() {
    world_.getDispatchInfo().m_deterministicOverlappingPairs = true;
    world_.setForceUpdateAllAabbs(false);
    world_.setGravity({0, 0, -kGravity_m_s2});
    add(&floor_shape_, btTransform::getIdentity(), 0, false);
  }
  ~Dynamics() {
    for (auto& body : bodies_) world_.removeRigidBody(&body);
  }
  Dynamics(const Dynamics&) = delete;
  Dynamics& operator=(const Dynamics&) = delete;

  void add_fixed(const Convex& part, bool rolls) { add(shape_of(part), to_bullet(part), 0, rolls); }

  btRigidBody& add_loose(const SettlingBody& body) {
    const auto& parts = body.collider->parts;
    const bool simple = parts.size() == 1 && parts.front().center.isZero() && parts.front().axes.isIdentity(0);
    btCollisionShape* shape = nullptr;
    if (simple) {
      shape = shape_of(parts.front());
    } else {
      auto& compound = compounds_.emplace_back(true, static_cast<int>(parts.size()));
      for (const Convex& part : parts) compound.addChildShape(to_bullet(part), shape_of(part));
      compound.setMargin(kSkin_m);
      shape = &compound;
    }
    return add(shape, to_bullet(body.pose), std::max(body.mass, 0.01), body.collider->rolls);
  }

  void step(double seconds) { world_.stepSimulation(seconds, 0, seconds); }

  std::size_t pairs() const { return static_cast<std::size_t>(dispatcher_.getNumManifolds()); }

  /// Whether every body's center is above its support and not near its edge.
  bool well_supported(const std::vector<btRigidBody*>& moving);

 private:
  btCollisionShape* shape_of(const Convex& part) {
    const btVector3 half = to_bullet(part.half);
    switch (part.kind) {
      case Part::Kind::Cylinder:
        cylinders_.emplace_back(half).setMargin(kSkin_m);
        return &cylinders_.back();
      case Part::Kind::Sphere:
        return &balls_.emplace_back(half.x());
      case Part::Kind::Box:
        break;
    }
    boxes_.emplace_back(half).setMargin(kSkin_m);
    return &boxes_.back();
  }

  btRigidBody& add(btCollisionShape* shape, const btTransform& pose, double mass, bool rolls) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0) shape->calculateLocalInertia(mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape, inertia);
    info.m_startWorldTransform = pose;
    info.m_friction = kFriction;
    info.m_rollingFriction = rolls ? kRollingFriction : 0;
    info.m_spinningFriction = rolls ? kRollingFriction : 0;
    info.m_linearDamping = 0.04;
    info.m_angularDamping = 0.1;
    btRigidBody& body = bodies_.emplace_back(info);
    if (mass > 0) body.setActivationState(DISABLE_DEACTIVATION);  // only moving bodies need updates
    world_.addRigidBody(&body);
    return body;
  }

  btDefaultCollisionConfiguration configuration_{small_pools()};
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  btStaticPlaneShape floor_shape_{btVector3(0, 0, 1), 0};
  std::deque<btBoxShape> boxes_;
  std::deque<btCylinderShapeZ> cylinders_;
  std::deque<btSphereShape> balls_;
  std::deque<btCompoundShape> compounds_;
  std::deque<btRigidBody> bodies_;
};

/// Signed distance of a point from the edge of the convex hull of the others, seen from above; positive inside. For
/// short lists.
double inside_hull(const Vec2& point, const std::vector<Vec2>& corners) {
  // The minimum over directions of the hull's support function minus that of the point.
  constexpr int kDirections = 16;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2 * std::numbers::pi * i / kDirections;
    const Vec2 direction(std::cos(angle), std::sin(angle));
    double farthest = -std::numeric_limits<double>::infinity();
    for (const Vec2& corner : corners) farthest = std::max(farthest, direction.dot(corner - point));
    least = std::min(least, farthest);
  }
  return least;
}

bool Dynamics::well_supported(const std::vector<btRigidBody*>& moving) {
  constexpr double kEdge_m = 0.03;  // nearer to an edge, 0.1 s of calm was not enough in tests
  constexpr double kShare = 0.4;    // fraction of the smaller half extent, for narrow bodies
  constexpr double kUpwards = 0.5;
  for (const btRigidBody* body : moving) {
    std::vector<Vec2> carried_at;
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
      const btPersistentManifold* manifold = dispatcher_.getManifoldByIndexInternal(i);
      const bool first = manifold->getBody0() == body;
      if (!first && manifold->getBody1() != body) continue;
      for (int k = 0; k < manifold->getNumContacts(); ++k) {
        const btManifoldPoint& point = manifold->getContactPoint(k);
        const double up = first ? point.m_normalWorldOnB.z() : -point.m_normalWorldOnB.z();
        const btVector3& at = point.getPositionWorldOnB();
        if (up > kUpwards) carried_at.emplace_back(at.x(), at.y());
      }
    }
    btVector3 low, high;
    body->getAabb(low, high);
    const double narrow = std::min(high.x() - low.x(), high.y() - low.y()) / 2;
    const btVector3& middle = body->getCenterOfMassPosition();
    const bool rolls = body->getRollingFriction() > 0;  // rests on a point or a line
    if (!rolls && inside_hull({middle.x(), middle.y()}, carried_at) < std::min(kEdge_m, kShare * narrow)) return false;
  }
  return true;
}

}  // namespace

Rest come_to_rest(const std::vector<SettlingBody>& fixed, const std::vector<SettlingBody>& loose, const Bounds& region,
                  const SettleOptions& options) {
  Dynamics dynamics;
  for (const SettlingBody& body : fixed) {
    for (const Convex& part : body.collider->placed(body.pose)) {
      if (overlap(part.bounds, region, options.surroundings_m)) dynamics.add_fixed(part, body.collider->rolls);
    }
  }
  std::vector<btRigidBody*> moving;
  for (const SettlingBody& body : loose) moving.push_back(&dynamics.add_loose(body));

  Rest rest;
  int calm_for = 0, wanted = options.calm_steps;
  for (int step = 0; step < options.max_steps && calm_for < wanted && rest.work < options.most_work; ++step) {
    dynamics.step(options.step_s);
    rest.work += moving.size() + dynamics.pairs();
    const bool calm = std::all_of(moving.begin(), moving.end(), [&](const btRigidBody* body) {
      return body->getLinearVelocity().length() < options.calm_m_s &&
             body->getAngularVelocity().length() < options.calm_rad_s;
    });
    calm_for = calm ? calm_for + 1 : 0;
    if (calm_for == options.calm_steps && wanted < options.edge_calm_steps && !dynamics.well_supported(moving)) {
      wanted = options.edge_calm_steps;
    }
  }
  rest.calm = calm_for >= wanted;
  for (const btRigidBody* body : moving) rest.poses.push_back(from_bullet(body->getWorldTransform()));
  return rest;
}

}  // namespace unietp
