#pragma once

#include <string_view>

#include "scene/scene.h"
#include "shapes/family.h"

namespace unietp {

/// Red, green and blue, 0 to 255, before shading.
using Color = Vec3;

/// A node's color: its own if known, else that of a material that has one color, else a usual one of its shape, else
/// that of its material or archetype; slightly varied by id.
Color paint_of(const Node& node, const ShapeFamily* family = nullptr);
/// Of the node's material; where that is not known, that of its shape, or what things of its archetype or with its
/// states are mostly made of.
Matter matter_of(const Node& node, const ShapeFamily* family = nullptr);
/// Of what fills or covers an object, by words of its name: coffee brown, milk white. Others: a pale yellow.
Color substance_paint(std::string_view substance);

/// Of walls where nothing else is known, ceilings and openings.
inline const Color kWallPaint(226, 221, 210), kCeilingPaint(240, 240, 238), kOpenPaint(205, 222, 235);

}  // namespace unietp
