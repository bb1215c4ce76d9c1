#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace unietp {

/// A top-down drawing of a scene as a self-contained SVG: rooms in the color of their type with their names, walls
/// with gaps at the openings, furniture by its kind, movable objects with their outline and color (paler in what is
/// shut), labels that keep clear of each other (a pointer that rests on a thing shows its id), a scale, the agent as a
/// triangle, and a walk: its legs as lines, with numbered stops at the start and at the end of each leg (a stop that is
/// come to again keeps its place and shows all of its numbers). North (+y) is up; 80 pixels a meter. Deterministic.
std::string scene_svg(const Scene& scene, const std::vector<std::vector<Vec2>>& legs = {});

}  // namespace unietp
