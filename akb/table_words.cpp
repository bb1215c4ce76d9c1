#include "akb/table_words.h"

#include <array>

#include "akb/rows.h"

namespace unietp {
namespace {

constexpr std::array<AffordanceMeaning, 24> kAffordances = {{
    {"burnable", "can be burnt"},
    {"breakable", "can be broken"},
    {"consumable", "can be used up"},
    {"container", "objects go into it"},
    {"cookable", "can be cooked"},
    {"coverable", "a substance can be spread on it"},
    {"dirtyable", "can be dirty, and cleaned"},
    {"drain", "what is poured into it is lost"},
    {"fillable", "can hold a liquid"},
    {"foldable", "can be folded"},
    {"freezable", "can be frozen"},
    {"heatable", "can be hot or cold"},
    {"heat_source", "makes other objects hot"},
    {"cold_source", "makes other objects cold"},
    {"lieable", "the agent can lie on it"},
    {"openable", "can be opened and closed"},
    {"pickupable", "the agent can carry it"},
    {"pluggable", "can be plugged in"},
    {"readable", "the agent can read it"},
    {"receptacle", "objects stand on it"},
    {"sittable", "the agent can sit on it"},
    {"sliceable", "can be cut into slices"},
    {"soakable", "can be soaked, as cloths and sponges are"},
    {"switchable", "can be switched on and off"},
}};

template <class Values, class NameOf>
std::vector<std::string> names_by(const Values& values, const NameOf& name_of) {
  std::vector<std::string> names;
  for (const auto& value : values) names.emplace_back(name_of(value));
  return names;
}

}  // namespace

std::span<const AffordanceMeaning> affordance_meanings() { return kAffordances; }

const std::vector<std::string>& affordance_names() {
  static const auto names = names_by(kAffordances, [](const AffordanceMeaning& row) { return row.name; });
  return names;
}

const std::vector<std::string>& relation_names() {
  static const auto names = names_by(kPlacementRelations, [](Predicate relation) { return info(relation).name; });
  return names;
}

const std::vector<std::string>& effect_names() {
  static const auto names = names_by(all_treatments(), [](const TreatmentInfo& row) { return row.name; });
  return names;
}

const std::vector<std::string>& need_names() {
  static const auto names = names_by(kEffectNeeds, [](EffectNeed need) { return name_of(need); });
  return names;
}

const std::vector<std::string>& alias_kinds() {
  static const auto names = names_by(kAliasKinds, [](AliasKind kind) { return name_of(kind); });
  return names;
}

const std::vector<std::string>& room_types() {
  static const std::vector<std::string> names{"kitchen",     "living_room", "bedroom", "bathroom",
                                              "dining_room", "corridor",    "office"};
  return names;
}

}  // namespace unietp
