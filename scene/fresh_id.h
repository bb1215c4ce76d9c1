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
/// A free id whose number is drawn from 1 to 99 by the names of the scene and the category, so that it does not tell
/// which things of a kind came first or were added for a task; from 1 to 999 and so on where most of the numbers are
/// taken. Equal scenes give equal ids. `before`: of the nodes of the home that the scene grew out of, whose ids are not
/// used again; may be nullptr.
std::string drawn_id(const Scene& scene, const NodeIndex& places, std::string_view category,
                     const NodeIndex* before = nullptr);

}  // namespace unietp
