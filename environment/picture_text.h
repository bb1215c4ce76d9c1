#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"
#include "scene/visible_object.h"

namespace unietp {

class Environment;

/// What the picture shows, in words, for agents that cannot see it: the states of the objects, and what they stand on
/// or are in. Where boxes are told, of the objects that are told, by id; otherwise of all objects in the picture, by
/// category and box in the settings' form. One line; "" when there is nothing to tell. Deterministic.
std::string picture_text(const Environment& environment);
/// The same of objects that are told by id, in the scene that they are seen in.
std::string picture_text(const Scene& scene, const std::vector<VisibleObject>& boxes);

}  // namespace unietp
