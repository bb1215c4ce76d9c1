#pragma once

#include <string>
#include <vector>

namespace unietp {

// The closed lists of words that the knowledge tables may use.

const std::vector<std::string>& affordance_names();  // of all_affordances: burnable breakable ...

const std::vector<std::string>& relation_names();  // of kPlacementRelations
const std::vector<std::string>& effect_names();    // of all_treatments: heats cools ... attaches
const std::vector<std::string>& need_names();      // of kEffectNeeds
const std::vector<std::string>& alias_kinds();     // of kAliasKinds
const std::vector<std::string>& room_types();      // kitchen living_room ...

}  // namespace unietp
