#include "interchange/unity.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace unietp {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

using Matrix = Eigen::Matrix3d;

/// The columns of a model's own axes in W (right, back, up of our object frame) at Unity's identity.
Matrix model_axes() {
  Matrix axes;
  axes << -1, 0, 0, 0, -1, 0, 0, 0, 1;
  return axes;
}

/// Swaps y and z: Unity's frame to W and back.
Matrix swap() {
  Matrix m;
  m << 1, 0, 0, 0, 0, 1, 0, 1, 0;
  return m;
}

double in_circle(double degrees) {
  const double turned = std::fmod(std::fmod(degrees, 360) + 360, 360);
  return turned > 360 - 1e-9 ? 0 : turned;
}

}  // namespace

Quat rotation_from_unity(const Vec3& degrees) {
  const Vec3 a = degrees * kDegree;
  const Matrix unity = (Eigen::AngleAxisd(a.y(), Vec3::UnitY()) * Eigen::AngleAxisd(a.x(), Vec3::UnitX()) *
                        Eigen::AngleAxisd(a.z(), Vec3::UnitZ()))
                           .toRotationMatrix();
  return Quat(Matrix(swap() * unity * swap() * model_axes())).normalized();
}

Vec3 rotation_to_unity(const Quat& rotation) {
  const Matrix m = swap() * rotation.toRotationMatrix() * model_axes().transpose() * swap();
  // m = Ry(y) Rx(x) Rz(z).
  const double x = std::asin(std::clamp(-m(1, 2), -1.0, 1.0));
  const bool locked = std::abs(m(1, 2)) > 1 - 1e-12;  // yaw and roll turn about one axis: all is yaw
  const double y = locked ? std::atan2(-m(2, 0), m(0, 0)) : std::atan2(m(0, 2), m(2, 2));
  const double z = locked ? 0 : std::atan2(m(1, 0), m(1, 1));
  return {in_circle(x / kDegree), in_circle(y / kDegree), in_circle(z / kDegree)};
}

Agent agent_from_unity(const Vec3& position, double yaw, double horizon) {
  Agent agent;
  agent.position = from_unity(position).head<2>();
  agent.yaw = std::remainder(std::numbers::pi / 2 - yaw * kDegree, 2 * std::numbers::pi);
  agent.pitch = horizon * kDegree;
  return agent;
}

double agent_yaw_to_unity(const Agent& agent) { return in_circle(90 - agent.yaw / kDegree); }

std::optional<PosedBox> box_of_corners(const std::array<Vec3, 8>& corners, const Quat& facing) {
  Vec3 center = Vec3::Zero();
  for (const Vec3& corner : corners) center += corner / 8;
  std::vector<Vec3> ways;
  for (std::size_t i = 1; i < corners.size(); ++i) ways.push_back(corners[i] - corners[0]);
  std::sort(ways.begin(), ways.end(), [](const Vec3& a, const Vec3& b) { return a.norm() < b.norm(); });
  std::vector<Vec3> edges;
  for (const Vec3& way : ways) {
    const bool upright = std::all_of(edges.begin(), edges.end(), [&](const Vec3& edge) {
      return std::abs(edge.normalized().dot(way.normalized())) < 0.02 + 0.0005 / std::min(edge.norm(), way.norm());
    });
    if (edges.size() < 3 && upright && way.norm() > 1e-4) edges.push_back(way);
  }
  if (edges.size() < 3) return std::nullopt;
  const Matrix wanted = facing.toRotationMatrix();
  Matrix axes;
  PosedBox box;
  std::vector<Vec3> left = edges;
  for (const int column : {2, 1}) {
    const auto nearest = std::max_element(left.begin(), left.end(), [&](const Vec3& a, const Vec3& b) {
      return std::abs(a.normalized().dot(wanted.col(column))) < std::abs(b.normalized().dot(wanted.col(column)));
    });
    const double sign = nearest->dot(wanted.col(column)) < 0 ? -1 : 1;
    axes.col(column) = sign * nearest->normalized();
    box.size[column] = nearest->norm();
    left.erase(nearest);
  }
  box.size[0] = left.front().norm();
  axes.col(1) = (axes.col(1) - axes.col(2) * axes.col(2).dot(axes.col(1))).normalized();
  axes.col(0) = axes.col(1).cross(axes.col(2));
  box.pose = {center, Quat(axes).normalized()};
  const Vec3 reach = bounds_of(Pose{Vec3::Zero(), box.pose.rotation}, box.size).high;
  for (const Vec3& corner : corners) {
    if (((corner - center).cwiseAbs() - reach).maxCoeff() > 0.02 + 0.05 * box.size.maxCoeff()) return std::nullopt;
  }
  return box;
}

PosedBox box_within(const Vec3& center, const Vec3& extents, const Quat& facing) {
  constexpr double kQuarter = std::numbers::pi / 2, kStraight_rad = 0.06;
  const double yaw = yaw_of(Pose{Vec3::Zero(), facing});
  const double quarters = std::round(yaw / kQuarter);
  const double off = yaw - quarters * kQuarter;
  const bool across = std::abs(std::lround(quarters)) % 2 == 1;
  const Vec3 straight = across ? Vec3(extents.y(), extents.x(), extents.z()) : extents;
  PosedBox snapped{upright(center, quarters * kQuarter), straight};
  if (std::abs(off) < kStraight_rad) return snapped;
  // straight.x = a cos + b sin, straight.y = a sin + b cos.
  const double c = std::cos(off), s = std::abs(std::sin(off)), determinant = c * c - s * s;
  if (determinant < 0.2) return snapped;
  const double a = (straight.x() * c - straight.y() * s) / determinant;
  const double b = (straight.y() * c - straight.x() * s) / determinant;
  constexpr double kLeast = 0.02;
  if (a < kLeast || b < kLeast) return snapped;
  return {upright(center, yaw), Vec3(a, b, extents.z())};
}

}  // namespace unietp
