#pragma once

#include <string>

#include "akb/knowledge.h"
#include "scene/scene.h"

namespace unietp {

/// The simulator's model that stands for a node: its own, when the knowledge base has that, else the one of its
/// category whose box is nearest. nullptr when there is none, or none whose box fits: each extent within a third of the
/// node's, or within 5 cm. `why` then says so, for people.
const Asset* model_for(const Node& node, const Knowledge& knowledge, std::string& why);

}  // namespace unietp
