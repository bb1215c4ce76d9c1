#pragma once

#include <cstddef>

#include "interchange/gltf.h"
#include "simulation/solid.h"

namespace unietp {

/// How many triangles `add_surface` adds.
std::size_t triangles_of(const Solid& solid, std::uint32_t sides);

/// Adds the surface of a solid that the camera shows to a mesh; the inside of a hollow, too. What is round has this
/// many sides (an even number, 4 at least), balls half as many rings. `to_file`: from W into the frame of the file.
void add_surface(GltfMesh& mesh, const Solid& solid, std::uint32_t sides, const Pose& to_file);

}  // namespace unietp
