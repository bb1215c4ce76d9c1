#pragma once

#include "scene/scene.h"

namespace unietp {

/// Red, green and blue, 0 to 255, before any light falls on it.
using Colour = Vec3;

/// A node's colour: the one that it is known to have, else that of its material, else one for its archetype. Nodes of
/// one colour differ by a shade, by their ids.
Colour paint_of(const Node& node);
/// Floors: tiles in kitchens and bathrooms, boards elsewhere, a plain grey outside of all rooms (nullptr).
Colour floor_paint(const Room* room, const Vec2& at);
inline const Colour kWallPaint(226, 221, 210), kCeilingPaint(240, 240, 238), kOpenPaint(205, 222, 235);

}  // namespace unietp
