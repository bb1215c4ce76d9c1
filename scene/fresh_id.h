#pragma once

#include <string>
#include <string_view>

#include "scene/node_index.h"
#include "scene/scene.h"

namespace unietp {

/// An id that no node, room or opening has yet, since all share the names that an action may say: "mug_4". Lower snake
/// case of the category plus the smallest free number from 1. `places`: of the scene's nodes.
std::string fresh_id(const Scene& scene, const NodeIndex& places, std::string_view category);
/// The same without an index, in time linear in the nodes.
std::string fresh_id(const Scene& scene, std::string_view category);

}  // namespace unietp
