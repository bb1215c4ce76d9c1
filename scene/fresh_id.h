#pragma once

#include <string>
#include <string_view>

#include "scene/node_index.h"
#include "scene/scene.h"

namespace unietp {

/// An id that no node, room or opening has yet, since all share the names that an action may say: "mug_4". Lower snake
/// case of the category plus the smallest free number from 1. `places`: of the scene's nodes; `before`: of those of the
/// home that it grew out of, whose ids are not used again; may be nullptr.
std::string fresh_id(const Scene& scene, const NodeIndex& places, std::string_view category,
                     const NodeIndex* before = nullptr);
/// The same without an index, in time linear in the nodes.
std::string fresh_id(const Scene& scene, std::string_view category);

}  // namespace unietp
