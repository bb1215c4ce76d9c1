#include "simulation/touch.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <btBulletCollisionCommon.h>

namespace unietp {
namespace {

using Kind = Part::Kind;
using Mat3 = Eigen::Matrix3d;

constexpr double kUpright = 1 - 1e-9;  // least |z| of an upright axis

bool stands_upright(const Convex& solid) { return std::abs(solid.axes(2, 2)) > kUpright; }

/// Separating axes; edges against edges win only when they are clearly shallower, as in the box test of ODE.
std::optional<Touch> boxes(const Convex& a, const Convex& b) {
  constexpr double kEdgeBias = 1.05, kParallel = 1e-5;
  const Vec3 apart = b.center - a.center;
  const Vec3 in_a = a.axes.transpose() * apart, in_b = b.axes.transpose() * apart;
  const Mat3 r = a.axes.transpose() * b.axes;
  const Mat3 q = r.cwiseAbs();
  double best = -std::numeric_limits<double>::infinity();  // the least overlap so far, negative
  Vec3 normal = Vec3::UnitZ();
  for (int i = 0; i < 3; ++i) {
    const double gap = std::abs(in_a[i]) - (a.half[i] + q.row(i).dot(b.half));
    if (gap > 0) return std::nullopt;
    if (gap > best) {
      best = gap;
      normal = in_a[i] < 0 ? Vec3(a.axes.col(i)) : Vec3(-a.axes.col(i));
    }
  }
  for (int i = 0; i < 3; ++i) {
    const double gap = std::abs(in_b[i]) - (b.half[i] + q.col(i).dot(a.half));
    if (gap > 0) return std::nullopt;
    if (gap > best) {
      best = gap;
      normal = in_b[i] < 0 ? Vec3(b.axes.col(i)) : Vec3(-b.axes.col(i));
    }
  }
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      const Vec3 axis = a.axes.col(i).cross(b.axes.col(k));
      const double length = axis.norm();
      if (length < kParallel) continue;
      const double along = apart.dot(axis);
      const double reach =
          a.half.dot((a.axes.transpose() * axis).cwiseAbs()) + b.half.dot((b.axes.transpose() * axis).cwiseAbs());
      const double gap = (std::abs(along) - reach) / length;
      if (gap > 0) return std::nullopt;
      if (gap * kEdgeBias > best) {
        best = gap;
        normal = along < 0 ? Vec3(axis / length) : Vec3(-axis / length);
      }
    }
  }
  return Touch{normal, -best};
}

/// The shallower of the vertical and the horizontal separation for two vertical prisms.
std::optional<Touch> standing(const Convex& a, const Convex& b, double sideways_depth, const Vec2& sideways_normal) {
  const double rise = a.center.z() - b.center.z();
  const double depth = a.half.z() + b.half.z() - std::abs(rise);
  if (depth < 0 || sideways_depth < 0) return std::nullopt;
  if (depth <= sideways_depth) return Touch{Vec3(0, 0, rise < 0 ? -1 : 1), depth};
  return Touch{Vec3(sideways_normal.x(), sideways_normal.y(), 0), sideways_depth};
}

std::optional<Touch> cylinder_on_box(const Convex& cylinder, const Convex& box) {
  const Vec2 x = box.axes.col(0).head<2>(), y = box.axes.col(1).head<2>();
  const Vec2 from = (cylinder.center - box.center).head<2>();
  const Vec2 local(from.dot(x), from.dot(y)), half = box.half.head<2>();
  const Vec2 out = local.cwiseAbs() - half;
  const Vec2 sign(local.x() < 0 ? -1 : 1, local.y() < 0 ? -1 : 1);
  Vec2 away;
  double distance = 0;  // of the axis from the rectangle, negative inside
  if (out.maxCoeff() <= 0) {
    away = out.x() > out.y() ? Vec2(sign.x(), 0) : Vec2(0, sign.y());
    distance = out.maxCoeff();
  } else {
    const Vec2 beyond = out.cwiseMax(0.0);
    distance = beyond.norm();
    away = beyond.cwiseProduct(sign) / distance;
  }
  return standing(cylinder, box, cylinder.half.x() - distance, away.x() * x + away.y() * y);
}

std::optional<Touch> cylinders(const Convex& a, const Convex& b) {
  const Vec2 from = (a.center - b.center).head<2>();
  const double distance = from.norm();
  const Vec2 away = distance > 1e-12 ? Vec2(from / distance) : Vec2(1, 0);
  return standing(a, b, a.half.x() + b.half.x() - distance, away);
}

/// A sphere against a box, sphere or cylinder, by the nearest point in the other's frame.
std::optional<Touch> ball_on(const Convex& ball, const Convex& other) {
  const double radius = ball.half.x();
  const Vec3 middle = other.axes.transpose() * (ball.center - other.center);
  Vec3 away;
  double distance = 0;
  if (other.kind == Kind::Sphere) {
    distance = middle.norm() - other.half.x();
    away = middle.norm() > 1e-12 ? Vec3(middle.normalized()) : Vec3::UnitZ();
  } else {
    const bool round = other.kind == Kind::Cylinder;
    // In the plane through its axis a cylinder is a rectangle.
    const double across = middle.head<2>().norm();
    const Vec3 along = round && across > 1e-12 ? Vec3(middle.x() / across, middle.y() / across, 0) : Vec3::UnitX();
    const Vec3 local = round ? Vec3(across, 0, middle.z()) : middle;
    const Vec3 half = round ? Vec3(other.half.x(), 1e9, other.half.z()) : other.half;
    const Vec3 out = local.cwiseAbs() - half;
    Vec3 direction = Vec3::Zero();
    if (out.maxCoeff() <= 0) {
      int axis = 0;
      distance = out.maxCoeff(&axis);
      direction[axis] = local[axis] < 0 ? -1 : 1;
    } else {
      const Vec3 beyond = out.cwiseMax(0.0);
      distance = beyond.norm();
      for (int i = 0; i < 3; ++i) direction[i] = (local[i] < 0 ? -1 : 1) * beyond[i] / distance;
    }
    away = round ? Vec3(direction.x() * along + Vec3(0, 0, direction.z())) : direction;
  }
  if (distance > radius) return std::nullopt;
  return Touch{other.axes * away, radius - distance};
}

btVector3 vector_of(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

btTransform transform_of(const Convex& solid) {
  const Mat3& m = solid.axes;
  return btTransform(btMatrix3x3(m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)),
                     vector_of(solid.center));
}

struct Nearest : btDiscreteCollisionDetectorInterface::Result {
  std::optional<Touch> found;
  void setShapeIdentifiersA(int, int) override {}
  void setShapeIdentifiersB(int, int) override {}
  void addContactPoint(const btVector3& normal, const btVector3&, btScalar distance) override {
    if (distance <= 0) found = Touch{Vec3(normal.x(), normal.y(), normal.z()), -distance};
  }
};

/// Tilted cylinders.
std::optional<Touch> by_gjk(const Convex& a, const Convex& b) {
  const auto with = [](const Convex& solid, const auto& use) {
    const auto thin = [&](auto shape) {
      shape.setMargin(kSkin_m);
      return use(shape);
    };
    if (solid.kind == Kind::Box) return thin(btBoxShape(vector_of(solid.half)));
    return thin(btCylinderShapeZ(vector_of(solid.half)));
  };
  return with(a, [&](const btConvexShape& first) {
    return with(b, [&](const btConvexShape& second) {
      btVoronoiSimplexSolver simplex;
      btGjkEpaPenetrationDepthSolver depth;
      btGjkPairDetector detector(&first, &second, &simplex, &depth);
      btGjkPairDetector::ClosestPointInput input;
      input.m_transformA = transform_of(a);
      input.m_transformB = transform_of(b);
      Nearest nearest;
      detector.getClosestPoints(input, nearest, nullptr);
      return nearest.found;
    });
  });
}

std::optional<Touch> turned(std::optional<Touch> touch) {
  if (touch) touch->normal = -touch->normal;
  return touch;
}

/// Clips a segment to a box: from `in` to `out`, fractions of the segment. False when it misses.
bool clip(const Vec3& from, const Vec3& way, const Vec3& low, const Vec3& high, double& in, double& out) {
  for (int i = 0; i < 3; ++i) {
    if (way[i] == 0) {
      if (from[i] < low[i] || from[i] > high[i]) return false;
      continue;
    }
    double a = (low[i] - from[i]) / way[i], b = (high[i] - from[i]) / way[i];
    if (a > b) std::swap(a, b);
    in = std::max(in, a);
    out = std::min(out, b);
    if (in > out) return false;
  }
  return true;
}

/// Narrows [in, out] to where the point is within `radius` of the origin (`dimensions` 2: of the z axis).
bool clip_round(const Vec3& from, const Vec3& way, double radius, int dimensions, double& in, double& out) {
  const auto dot = [dimensions](const Vec3& u, const Vec3& v) { return u.head(dimensions).dot(v.head(dimensions)); };
  const double a = dot(way, way), b = dot(from, way), c = dot(from, from) - radius * radius;
  if (a == 0) return c <= 0;
  const double root = b * b - a * c;
  if (root < 0) return false;
  in = std::max(in, (-b - std::sqrt(root)) / a);
  out = std::min(out, (-b + std::sqrt(root)) / a);
  return in <= out;
}

}  // namespace

std::optional<Touch> touch(const Convex& a, const Convex& b) {
  if (!overlap(a.bounds, b.bounds)) return std::nullopt;
  if (a.kind == Kind::Box && b.kind == Kind::Box) return boxes(a, b);
  if (a.kind == Kind::Sphere) return ball_on(a, b);
  if (b.kind == Kind::Sphere) return turned(ball_on(b, a));
  if (!stands_upright(a) || !stands_upright(b)) return by_gjk(a, b);
  if (a.kind == Kind::Box) return turned(cylinder_on_box(b, a));
  return b.kind == Kind::Box ? cylinder_on_box(a, b) : cylinders(a, b);
}

std::optional<double> entry(const Convex& solid, const Vec3& from, const Vec3& way) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const Vec3 start = solid.axes.transpose() * (from - solid.center), along = solid.axes.transpose() * way;
  double in = -kFar, out = kFar;
  bool hit = false;
  switch (solid.kind) {
    case Kind::Box:
      hit = clip(start, along, -solid.half, solid.half, in, out);
      break;
    case Kind::Cylinder:
      hit = clip_round(start, along, solid.half.x(), 2, in, out) &&
            clip(start, along, Vec3(-kFar, -kFar, -solid.half.z()), Vec3(kFar, kFar, solid.half.z()), in, out);
      break;
    case Kind::Sphere:
      hit = clip_round(start, along, solid.half.x(), 3, in, out);
      break;
  }
  if (!hit || in < 0 || in > 1) return std::nullopt;
  return in;
}

bool meets(const Bounds& bounds, const Vec3& from, const Vec3& way, double most) {
  double in = 0, out = most;
  return clip(from, way, bounds.low, bounds.high, in, out);
}

}  // namespace unietp
