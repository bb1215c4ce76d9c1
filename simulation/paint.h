#pragma once

#include "scene/scene.h"

namespace unietp {

/// Red, green and blue, 0 to 255, before shading.
using Colour = Vec3;

/// A node's colour: its own if known, else that of its material, else that of its archetype, slightly varied by id.
Colour paint_of(const Node& node);
/// Floors: tiles in kitchens and bathrooms, boards elsewhere, a plain grey outside of all rooms (nullptr).
Colour floor_paint(const Room* room, const Vec2& at);
/// Of walls, ceilings and openings.
inline const Colour kWallPaint(226, 221, 210), kCeilingPaint(240, 240, 238), kOpenPaint(205, 222, 235);

}  // namespace unietp
