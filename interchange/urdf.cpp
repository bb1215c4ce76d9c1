#include "interchange/urdf.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/text.h"

namespace unietp {
namespace {

std::string number(double value) { return number_text(std::round(value * 1e6) / 1e6 + 0.0); }

std::string numbers(const Vec3& v) { return number(v.x()) + " " + number(v.y()) + " " + number(v.z()); }

/// Angles about the fixed axes x, y and z, one after the other, which is how URDF writes rotations.
Vec3 roll_pitch_yaw(const Quat& rotation) {
  constexpr double kUpright = 1 - 1e-9;  // of a sine: roll and yaw turn about the same axis
  const Eigen::Matrix3d m = rotation.toRotationMatrix();
  const double sine = std::clamp(-m(2, 0), -1.0, 1.0);
  if (std::abs(sine) > kUpright) return {std::atan2(-m(1, 2), m(1, 1)), std::asin(sine), 0};
  return {std::atan2(m(2, 1), m(2, 2)), std::asin(sine), std::atan2(m(1, 0), m(0, 0))};
}

std::string origin(const Pose& pose) {
  return "<origin xyz=\"" + numbers(pose.position) + "\" rpy=\"" + numbers(roll_pitch_yaw(pose.rotation)) + "\"/>";
}

std::string geometry(const Part& part) {
  const Vec3& size = part.size;
  switch (part.kind) {
    case Part::Kind::Cylinder:
      return "<cylinder radius=\"" + number(std::max(size.x(), size.y()) / 2) + "\" length=\"" + number(size.z()) +
             "\"/>";
    case Part::Kind::Sphere:
      return "<sphere radius=\"" + number(size.maxCoeff() / 2) + "\"/>";
    case Part::Kind::Box:
      break;
  }
  return "<box size=\"" + numbers(size) + "\"/>";
}

double volume_of(const Shape& shape, int joint) {
  double volume = 0;
  for (const Part& part : shape.parts) volume += part.joint == joint ? part.size.prod() : 0;
  return volume;
}

class UrdfWriter {
 public:
  UrdfWriter(const Shape& shape, const Pose& to_file, const std::array<double, 3>& color)
      : shape_(shape), to_file_(to_file), color_(color) {}

  /// A link with the parts that move with a joint; its frame has its origin on the joint's axis.
  std::string link(int joint, const Vec3& size, double mass) const {
    const Vec3 from = joint < 0 ? Vec3(0, 0, 0) : shape_.joints[static_cast<std::size_t>(joint)].anchor;
    std::string text = " <link name=\"" + name_of_link(joint) + "\">\n" + inertial(joint, from, size, mass);
    for (const Part& part : shape_.parts) {
      if (part.joint != joint) continue;
      const Pose pose = to_file_ * Pose{part.pose.position - from, part.pose.rotation};
      const std::string solid = "   " + origin(pose) + "\n   <geometry>" + geometry(part) + "</geometry>\n";
      text += "  <visual>\n" + solid + "   <material name=\"paint\"><color rgba=\"" +
              numbers({color_[0], color_[1], color_[2]}) + " 1\"/></material>\n  </visual>\n";
      text += "  <collision>\n" + solid + "  </collision>\n";
    }
    return text + " </link>\n";
  }

  std::string joint(int i) const {
    const Joint& joint = shape_.joints[static_cast<std::size_t>(i)];
    const bool back = joint.travel < 0;  // limits are ascending
    const Vec3 axis = rotated(to_file_.rotation, back ? Vec3(-joint.axis) : joint.axis);
    return " <joint name=\"joint_" + std::to_string(i) + "\" type=\"" +
           (joint.kind == Joint::Kind::Hinge ? "revolute" : "prismatic") + "\">\n  <parent link=\"body\"/>\n" +
           "  <child link=\"" + name_of_link(i) + "\"/>\n  " + origin({to_file_ * joint.anchor, Quat::Identity()}) +
           "\n  <axis xyz=\"" + numbers(axis) + "\"/>\n  <limit lower=\"0\" upper=\"" + number(std::abs(joint.travel)) +
           "\" effort=\"100\" velocity=\"1\"/>\n </joint>\n";
  }

 private:
  static std::string name_of_link(int joint) { return joint < 0 ? "body" : "part_" + std::to_string(joint); }

  /// Of a solid box around the link's parts.
  std::string inertial(int joint, const Vec3& from, const Vec3& size, double mass) const {
    Vec3 low = Vec3::Zero(), high = Vec3::Zero();
    bool any = false;
    for (const Part& part : shape_.parts) {
      if (part.joint != joint) continue;
      const Vec3 a = part.pose.position - part.size / 2, b = part.pose.position + part.size / 2;
      low = any ? Vec3(low.cwiseMin(a)) : a, high = any ? Vec3(high.cwiseMax(b)) : b;
      any = true;
    }
    const Vec3 extent = any ? Vec3(high - low) : size, middle = any ? Vec3((low + high) / 2) : from;
    const Vec3 squares = extent.cwiseProduct(extent);
    const auto moment = [&](double a, double b) { return number(std::max(mass * (a + b) / 12, 1e-6)); };
    return "  <inertial>\n   " + origin(to_file_ * Pose{middle - from, Quat::Identity()}) + "\n   <mass value=\"" +
           number(mass) + "\"/>\n   <inertia ixx=\"" + moment(squares.y(), squares.z()) + "\" iyy=\"" +
           moment(squares.x(), squares.z()) + "\" izz=\"" + moment(squares.x(), squares.y()) +
           "\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>\n  </inertial>\n";
  }

  const Shape& shape_;
  const Pose& to_file_;
  const std::array<double, 3>& color_;
};

}  // namespace

std::string write_urdf(const std::string& name, const Shape& shape, const Vec3& size, double mass, const Pose& to_file,
                       const std::array<double, 3>& color) {
  const UrdfWriter writer(shape, to_file, color);
  const auto joints = static_cast<int>(shape.joints.size());
  double whole = volume_of(shape, -1);
  for (int i = 0; i < joints; ++i) whole += volume_of(shape, i);
  const auto share = [&](int joint) {
    return std::max(1e-3, whole > 0 ? mass * volume_of(shape, joint) / whole : mass / (1 + joints));
  };
  std::string text = "<?xml version=\"1.0\"?>\n<robot name=\"" + name + "\">\n" + writer.link(-1, size, share(-1));
  for (int i = 0; i < joints; ++i) text += writer.link(i, size, share(i)) + writer.joint(i);
  return text + "</robot>\n";
}

}  // namespace unietp
