#pragma once

#include "akb/knowledge.h"
#include "scene/scene.h"

namespace unietp {

/// The first state of each group whose affordance the node's category has.
void set_default_states(Node& node, const Knowledge& knowledge);

}  // namespace unietp
