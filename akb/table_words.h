#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace unietp {

// The closed lists of words that the knowledge tables may use.

/// The names of affordances that tables may use: pickupable, receptacle (things can be put on it), container (things
/// can be put inside it), openable, switchable, sliceable, cookable, heatable, freezable, dirtyable, fillable,
/// breakable, foldable, soakable, consumable, coverable, sittable, lieable, pluggable, burnable, heat_source,
/// cold_source, drain.
const std::vector<std::string>& affordance_names();

/// What a category with an affordance can have done to it, or can do.
struct AffordanceMeaning {
  std::string_view name, says;
};
/// In the order of affordance_names().
std::span<const AffordanceMeaning> affordance_meanings();

const std::vector<std::string>& relation_names();  // of kPlacementRelations
const std::vector<std::string>& effect_names();    // of all_treatments: heats cools ... attaches
const std::vector<std::string>& need_names();      // of kEffectNeeds
const std::vector<std::string>& alias_kinds();     // of kAliasKinds
const std::vector<std::string>& room_types();      // kitchen living_room ...

}  // namespace unietp
