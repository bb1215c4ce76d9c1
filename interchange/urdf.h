#pragma once

#include <array>
#include <string>

#include "scene/geometry.h"
#include "simulation/shape.h"

namespace unietp {

/// A robot description (URDF) of an object with doors, lids or drawers, in meters, kilograms and radians: the link
/// `body`, and a link `part_<n>` with a joint `joint_<n>` for each joint of the shape, at 0 when closed. Boxes,
/// cylinders and spheres are URDF's own; `to_file` turns the object's frame into that of the file. The mass is shared
/// among the links by the volume of their parts. `color`: RGB from 0 to 1. Deterministic.
std::string write_urdf(const std::string& name, const Shape& shape, const Vec3& size, double mass, const Pose& to_file,
                       const std::array<double, 3>& color);

}  // namespace unietp
