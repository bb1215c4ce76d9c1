#include "simulation/collider.h"

#include <limits>

namespace unietp {
namespace {

Bounds bounds_around(const Vec3& center, const Eigen::Matrix3d& axes, const Vec3& half) {
  const Vec3 reach = axes.cwiseAbs() * half;
  return {center - reach, center + reach};
}

Bounds bounds_of(const Convex& part) {
  if (part.kind == Part::Kind::Sphere) {
    const Vec3 reach = Vec3::Constant(part.half.x());
    return {part.center - reach, part.center + reach};
  }
  return bounds_around(part.center, part.axes, part.half);
}

void add(Digester& digester, const Vec3& v) { digester.add(v.x()).add(v.y()).add(v.z()); }

void append_bytes(std::string& bytes, const void* from, std::size_t size) {
  bytes.append(static_cast<const char*>(from), size);
}

}  // namespace

Collider::Collider(Shape of, double at) : shape(std::move(of)), opening(at) {
  Bounds all{Vec3::Constant(std::numeric_limits<double>::infinity()),
             Vec3::Constant(-std::numeric_limits<double>::infinity())};
  Digester digester;
  parts.reserve(shape.parts.size());
  for (const Part& part : shape.parts) {
    const Pose pose = joint_motion(shape, part.joint, opening) * part.pose;
    Convex convex{part.kind, pose.position, pose.rotation.toRotationMatrix(), part.size / 2, {}};
    convex.bounds = bounds_of(convex);
    all.low = all.low.cwiseMin(convex.bounds.low);
    all.high = all.high.cwiseMax(convex.bounds.high);
    rolls = rolls || part.kind != Part::Kind::Box;
    digester.add(static_cast<std::uint64_t>(part.kind));
    add(digester, convex.center);
    add(digester, convex.half);
    for (int axis = 0; axis < 2; ++axis) add(digester, convex.axes.col(axis));
    parts.push_back(convex);
  }
  if (parts.empty()) all = {};
  center = (all.low + all.high) / 2;
  half = (all.high - all.low) / 2 + Vec3::Constant(kSkin_m);
  digest = digester.digest();
}

Bounds Collider::bounds(const Pose& pose) const {
  return bounds_around(pose * center, pose.rotation.toRotationMatrix(), half);
}

std::vector<Convex> Collider::placed(const Pose& pose) const {
  const Eigen::Matrix3d turn = pose.rotation.toRotationMatrix();
  std::vector<Convex> all = parts;
  for (Convex& part : all) {
    part.center = pose.position + turn * part.center;
    part.axes = turn * part.axes;
    part.bounds = bounds_of(part);
  }
  return all;
}

std::shared_ptr<const Collider> ColliderCache::of(const Node& node) {
  std::string key;
  const auto form = static_cast<std::uint64_t>(node.archetype) * 2 + (node.openable ? 1 : 0);
  append_bytes(key, &form, sizeof form);
  append_bytes(key, node.size.data(), 3 * sizeof(double));
  append_bytes(key, &node.opening, sizeof(double));
  for (const Board& board : node.boards) {
    append_bytes(key, board.center.data(), 3 * sizeof(double));
    append_bytes(key, board.size.data(), 3 * sizeof(double));
    append_bytes(key, &board.joint, sizeof board.joint);
  }
  auto& known = known_[std::move(key)];
  if (known == nullptr) known = std::make_shared<const Collider>(shape_of(node), node.opening);
  return known;
}

}  // namespace unietp
