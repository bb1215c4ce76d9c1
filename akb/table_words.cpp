#include "akb/table_words.h"

#include "akb/rows.h"

namespace unietp {
namespace {

template <class Values, class NameOf>
std::vector<std::string> names_by(const Values& values, const NameOf& name_of) {
  std::vector<std::string> names;
  for (const auto& value : values) names.emplace_back(name_of(value));
  return names;
}

}  // namespace

const std::vector<std::string>& affordance_names() {
  static const auto names = names_by(all_affordances(), [](const AffordanceInfo& row) { return row.name; });
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
