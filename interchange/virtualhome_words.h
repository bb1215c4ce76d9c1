#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "akb/knowledge.h"
#include "interchange/format_facts.h"
#include "scene/states.h"

namespace unietp {

// The words of the tables virtualhome_rooms.csv and virtualhome_states.csv.

/// "livingroom" → "living_room"; a name that is not listed stays as it is, in lower case.
std::string room_type_of_virtualhome(std::string_view class_name, const FormatFacts& facts);
/// "living_room" → "livingroom": the first that is listed.
std::string virtualhome_room_name(std::string_view type, const FormatFacts& facts);

/// "OPEN" → open; nothing for those that a scene does not hold ("SITTING").
std::optional<State> state_of_virtualhome(std::string_view name, const FormatFacts& facts);
/// open → "OPEN"; "" when VirtualHome has no word for it.
std::string_view virtualhome_state(Predicate predicate, const FormatFacts& facts);

/// "Furniture", "Food", …: the group that VirtualHome sorts a class into. Source: derived from the affordances.
std::string virtualhome_group(const Category& category, const Knowledge& knowledge);

}  // namespace unietp
