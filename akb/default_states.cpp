#include "akb/default_states.h"

namespace unietp {

void set_default_states(Node& node, const Knowledge& knowledge) {
  for (const StateGroup& group : state_groups()) {
    if (knowledge.has(node.category, group.affordance)) node.states.set({group.predicates.front(), {}});
  }
}

}  // namespace unietp
