#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "scene/geometry.h"
#include "simulation/shape.h"

namespace unietp {

/// What light does on a surface, in the terms of glTF 2.0: color in linear RGB, all values from 0 to 1.
struct GltfMaterial {
  std::array<double, 3> color{1, 1, 1};
  double opacity = 1, roughness = 1, metallic = 0;

  bool operator==(const GltfMaterial&) const = default;
};

/// A mesh of triangles that are counter-clockwise seen from outside, in glTF's frame (right-handed, y up, meters).
struct GltfMesh {
  std::string name;
  GltfMaterial material;
  std::vector<Vec3> points, normals;   // equally many; normals have unit length
  std::vector<std::uint32_t> corners;  // three a triangle, positions in `points`
};

/// The surface of a part in its own frame: 12 triangles for a box, 24 sides for a cylinder, 24 by 12 for a sphere that
/// is stretched to the part's size. `to_file` turns it into the frame of the file.
GltfMesh mesh_of(const Part& part, const Pose& to_file, std::string name, const GltfMaterial& material);

/// A binary glTF 2.0 file with one node for each mesh. Numbers are single precision. Deterministic.
std::string write_glb(const std::vector<GltfMesh>& meshes);

}  // namespace unietp
