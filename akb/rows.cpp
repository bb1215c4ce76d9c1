#include "akb/rows.h"

#include <algorithm>

namespace unietp {

bool well_formed_source(std::string_view source) {
  if (source == "curated") return true;
  for (const std::string_view kind : {"metadata:", "derived:", "llm:", "override:"}) {
    if (source.starts_with(kind)) {
      const auto name = source.substr(kind.size());
      return !name.empty() && name.find_first_of(" \t\r\n") == std::string_view::npos;
    }
  }
  return false;
}

namespace {

constexpr std::array<std::string_view, kEffectNeeds.size()> kNeedNames{"closed", "power_on", "held",
                                                                       "inside", "on",       "under_tap"};
constexpr std::array<std::string_view, kAliasKinds.size()> kKindNames{"synonym",     "function", "context", "hypernym",
                                                                      "description", "occasion", "request"};
constexpr std::array<std::string_view, kKindTraits.size()> kTraitNames{
    "one_size",     "not_by_size", "not_by_opening", "raw_or_cooked", "seen_running",
    "told_by_room", "puts_away",   "gives_light",    "dish"};

template <class Value, std::size_t kCount>
std::optional<Value> value_named(std::string_view name, const std::array<Value, kCount>& values,
                                 const std::array<std::string_view, kCount>& names) {
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end()) return std::nullopt;
  return values[static_cast<std::size_t>(at - names.begin())];
}

}  // namespace

std::optional<Predicate> placement_relation_named(std::string_view name) {
  const auto predicate = predicate_named(name);
  const auto at = std::find(kPlacementRelations.begin(), kPlacementRelations.end(), predicate);
  return at == kPlacementRelations.end() ? std::nullopt : predicate;
}

std::string_view name_of(KindTrait trait) { return kTraitNames[static_cast<std::size_t>(trait)]; }
std::optional<KindTrait> kind_trait_named(std::string_view name) { return value_named(name, kKindTraits, kTraitNames); }

bool has_trait(const Category& category, KindTrait trait) {
  return std::find(category.traits.begin(), category.traits.end(), trait) != category.traits.end();
}

std::vector<std::string> names_of(const std::vector<KindTrait>& traits) {
  std::vector<std::string> names;
  names.reserve(traits.size());
  for (const KindTrait trait : traits) names.emplace_back(name_of(trait));
  return names;
}

std::string_view name_of(EffectNeed need) { return kNeedNames[static_cast<std::size_t>(need)]; }
std::optional<EffectNeed> effect_need_named(std::string_view name) {
  return value_named(name, kEffectNeeds, kNeedNames);
}

bool has_need(const Effect& effect, EffectNeed need) {
  return std::find(effect.needs.begin(), effect.needs.end(), need) != effect.needs.end();
}

std::vector<std::string> names_of(const std::vector<EffectNeed>& needs) {
  std::vector<std::string> names;
  names.reserve(needs.size());
  for (const EffectNeed need : needs) names.emplace_back(name_of(need));
  return names;
}

std::string_view name_of(AliasKind kind) { return kKindNames[static_cast<std::size_t>(kind)]; }
std::optional<AliasKind> alias_kind_named(std::string_view name) { return value_named(name, kAliasKinds, kKindNames); }

}  // namespace unietp
