#pragma once

#include <string>

#include "scene/pixel_box.h"

namespace unietp {

/// An object in the camera's image: the box [x0, y0, x1, y1] around its pixels, x right, y down, both ends included.
struct VisibleObject {
  std::string id;
  PixelBox box{};
  bool operator==(const VisibleObject&) const = default;
};

}  // namespace unietp
