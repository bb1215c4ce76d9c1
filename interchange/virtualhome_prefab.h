#pragma once

#include <optional>
#include <string_view>

#include "akb/knowledge.h"
#include "interchange/format_facts.h"
#include "scene/scene.h"

namespace unietp {

/// The prefab that stands for an object in VirtualHome: the one that it came with, else that of its class whose box is
/// nearest to the object's, which is then scaled to it; of a class without known sizes its first. No name where the
/// class has none.
Prefab virtualhome_prefab(const Node& node, const Knowledge& knowledge, const FormatFacts& facts);

/// The size of the prefab with this name; nothing where none is known.
std::optional<Vec3> size_of_prefab(std::string_view name, std::string_view category, const Knowledge& knowledge,
                                   const FormatFacts& facts);

}  // namespace unietp
