#pragma once

#include "grounding/svg_canvas.h"
#include "scene/scene.h"

namespace unietp {

/// Draws furniture from above so that its kind shows: beds have pillows, seats a back, basins a hollow, shelves their
/// boards, doors and drawers a front (and stand open when they do). What hangs high is dashed.
void draw_furniture(SvgCanvas& canvas, const Node& node);

/// Draws a movable object with the outline from above of the shape that the camera shows, in its own color where that
/// is known; paler when something hides it.
void draw_object(SvgCanvas& canvas, const Node& node, Simulator simulator, bool hidden);

/// The corners of a node's box on the floor plan.
std::vector<Vec2> footprint_of(const Pose& pose, const Vec3& size);

/// True of what hangs over people's heads or on a wall above furniture.
bool hangs_high(const Node& node);

}  // namespace unietp
