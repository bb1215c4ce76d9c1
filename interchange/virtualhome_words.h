#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "akb/knowledge.h"
#include "scene/states.h"

namespace unietp {

/// "livingroom" → "living_room"; a name that is not listed stays as it is.
std::string room_type_of_virtualhome(std::string_view class_name);
/// "living_room" → "livingroom".
std::string virtualhome_room_name(std::string_view type);

/// "OPEN" → open; nothing for those that a scene does not hold ("SITTING").
std::optional<State> state_of_virtualhome(std::string_view name);
/// open → "OPEN"; "" when VirtualHome has no word for it.
std::string_view virtualhome_state(Predicate predicate);

/// An affordance of the knowledge base and VirtualHome's word for it.
struct VirtualhomeProperty {
  std::string_view affordance, property;
};
/// In the order in which a written graph lists them.
inline constexpr std::array<VirtualhomeProperty, 11> kVirtualhomeProperties{{{"pickupable", "GRABBABLE"},
                                                                             {"receptacle", "SURFACES"},
                                                                             {"container", "CONTAINERS"},
                                                                             {"openable", "CAN_OPEN"},
                                                                             {"switchable", "HAS_SWITCH"},
                                                                             {"sittable", "SITTABLE"},
                                                                             {"lieable", "LIEABLE"},
                                                                             {"sliceable", "CUTTABLE"},
                                                                             {"consumable", "EATABLE"},
                                                                             {"pluggable", "HAS_PLUG"},
                                                                             {"fillable", "RECIPIENT"}}};

/// "Furniture", "Food", …: the group that VirtualHome sorts a class into. Source: derived from the affordances.
std::string virtualhome_group(const Category& category, const Knowledge& knowledge);

}  // namespace unietp
