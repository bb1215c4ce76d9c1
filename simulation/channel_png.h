#pragma once

#include <string>

#include "core/result.h"
#include "simulation/channels.h"

namespace unietp {

/// Channels as PNG files of the size of the picture. Deterministic. Errors: those of core/png.h.

/// 16 bits gray: millimeters; 0 where nothing is or what is there is more than 65.535 m away.
Result<std::string> depth_png(const Channels& channels);
/// Red, green, blue: right, down and ahead in the camera's frame, -1 to 1 as 0 to 255.
Result<std::string> normals_png(const Channels& channels);
/// 16 bits gray: position of the node plus 1; 0 for walls, floor, ceiling and where nothing is.
Result<std::string> instances_png(const Channels& channels);

}  // namespace unietp
