#include <nlohmann/json.hpp>

#include <algorithm>

#include "akb/import_behavior.h"
#include "core/text.h"

namespace unietp::behavior {
namespace {

using Json = nlohmann::json;

/// Furniture and appliances that stand in homes; the others do the same but no home has them.
bool in_homes(const TableBuilder& builder, const std::string& name) { return !builder.find(name)->rooms.empty(); }

std::vector<EffectNeed> needs_of(const Json& source) {
  std::vector<EffectNeed> needs;
  if (source.value("requires_closed", 0.0) > 0) needs.push_back(EffectNeed::Closed);
  if (source.value("requires_toggled_on", 0.0) > 0) needs.push_back(EffectNeed::PowerOn);
  needs.push_back(source.value("requires_inside", 0.0) > 0 ? EffectNeed::Inside : EffectNeed::On);
  return needs;
}

/// The temperature at which a thing cooks, in °C; 0 for one that does not.
double cooked_at(const Metadata& metadata, const Json& annotations, const std::string& target) {
  const auto& synset = metadata.categories.at(target).synset;
  if (!annotations.contains(synset) || !annotations.at(synset).contains("cookable")) return 0;
  return annotations.at(synset).at("cookable").value("cook_temperature", 0.0);
}

/// How warm things get at a source at last, in °C: OmniGibson lets them lose heat to the room.
double warmed_to(const Json& source) {
  constexpr double kRoom_C = 23, kLoss_per_s = 0.02;  // OmniGibson 1.1.1, object_states/temperature.py
  const double rate = source.value("heating_rate", 0.0);
  return (source.value("temperature", 0.0) * rate + kRoom_C * kLoss_per_s) / (rate + kLoss_per_s);
}

void add_heat(TableBuilder& builder, const Metadata& metadata, const Json& annotations, const std::string& tool,
              const Json& source) {
  if (!builder.is_kind(tool, KindGroup::Heater) || !builder.has(tool, "switchable")) return;
  const bool flame = builder.is_kind(tool, KindGroup::OpenFlame);
  const auto ware = flame                                         ? KindGroup::StoveWare
                    : builder.is_kind(tool, KindGroup::Microwave) ? KindGroup::MicrowaveWare
                                                                  : KindGroup::OvenWare;
  for (const auto& target : builder.names()) {
    if (!builder.has(target, "pickupable")) continue;
    const auto add = [&](Treatment treatment) {
      builder.effect({tool, treatment, target, "", 0, needs_of(source), {kAnnotations, 1}});
    };
    // An open flame burns food that lies on it, a closed oven cooks it.
    const bool burns = flame && builder.has(target, "burnable");
    if (burns) add(Treatment::Burns);
    const bool suits = builder.is_kind(target, KindGroup::Food) || builder.is_kind(target, ware);
    if (!burns && suits && builder.has(target, "heatable")) add(Treatment::Heats);
    const bool cooks = builder.has(target, "cookable") && warmed_to(source) >= cooked_at(metadata, annotations, target);
    if (!flame && cooks) add(Treatment::Cooks);
  }
}

void add_cold(TableBuilder& builder, const std::string& tool, const Json& source) {
  if (!builder.is_kind(tool, KindGroup::Cooler)) return;
  for (const auto& target : builder.names()) {
    if (!builder.has(target, "pickupable")) continue;
    const auto add = [&](Treatment treatment) {
      builder.effect({tool, treatment, target, "", 0, needs_of(source), {kAnnotations, 1}});
    };
    if (builder.has(target, "heatable")) add(Treatment::Cools);
    // The annotations let fridges freeze, too.
    const bool freezes = builder.is_kind(tool, KindGroup::Freezer) && source.value("temperature", 0.0) < 0;
    if (freezes && builder.has(target, "freezable")) add(Treatment::Freezes);
  }
}

void add_temperature(TableBuilder& builder, const Metadata& metadata, const Json& annotations) {
  for (const auto& tool : builder.names()) {
    const auto& synset = metadata.categories.at(tool).synset;
    if (!annotations.contains(synset) || !in_homes(builder, tool)) continue;
    const auto& properties = annotations.at(synset);
    if (properties.contains("heatSource")) add_heat(builder, metadata, annotations, tool, properties.at("heatSource"));
    if (properties.contains("coldSource")) add_cold(builder, tool, properties.at("coldSource"));
  }
}

void add_washing(TableBuilder& builder) {
  for (const auto& tool : builder.names()) {
    if (!builder.is_kind(tool, KindGroup::Washer) || !in_homes(builder, tool)) continue;
    for (const auto& target : builder.names()) {
      if (!builder.has(target, "pickupable")) continue;
      const auto add = [&](Treatment treatment, const char* gives, std::vector<EffectNeed> needs) {
        builder.effect({tool, treatment, target, gives, 0, std::move(needs), {"curated", 0.9}});
      };
      const bool cloth = builder.is_kind(target, KindGroup::Laundry);
      const bool dirty = builder.has(target, "dirtyable");
      if (builder.is_kind(tool, KindGroup::UnderTap)) {
        if (dirty) add(Treatment::Washes, "", {EffectNeed::UnderTap});
        if (builder.has(target, "fillable")) add(Treatment::Fills, "water", {EffectNeed::UnderTap});
        if (builder.has(target, "fillable")) add(Treatment::Drains, "", {});
        if (builder.has(target, "soakable")) add(Treatment::Soaks, "water", {EffectNeed::UnderTap});
      } else if (dirty && cloth == builder.is_kind(tool, KindGroup::WashesLaundry)) {
        add(Treatment::Washes, "", {EffectNeed::Closed, EffectNeed::PowerOn, EffectNeed::Inside});
      }
    }
  }
}

void add_wiping(TableBuilder& builder, const std::set<std::string>& usual) {
  for (const auto& tool : builder.names()) {
    if (!builder.has(tool, "soakable") || !usual.contains(tool)) continue;
    for (const auto& target : builder.names()) {
      const bool cloth = builder.is_kind(target, KindGroup::WornOrSpread);
      if (tool == target || cloth || !builder.has(target, "coverable")) continue;
      if (!builder.has(target, "pickupable") && !in_homes(builder, target)) continue;
      builder.effect({tool, Treatment::Wipes, target, "", 0, {EffectNeed::Held}, {"curated", 0.9}});
    }
  }
}

/// Food is cut with the kitchen's knives, the rest with the other blades.
void add_slicing(TableBuilder& builder, const Metadata& metadata, const Json& transitions) {
  for (const auto& [whole, pieces] : pieces_of(builder, metadata, transitions)) {
    const bool food = builder.is_kind(whole, KindGroup::Food);
    for (const auto& tool : builder.names()) {
      if (!metadata.categories.at(tool).properties.contains("slicer") || !builder.has(tool, "pickupable")) continue;
      if (builder.is_kind(tool, KindGroup::KitchenBlade) != food) continue;
      builder.effect(
          {tool, Treatment::Slices, whole, pieces.category, pieces.amount, {EffectNeed::Held}, {kSlicing, 1}});
    }
  }
}

/// What a tool applies or pours: by its annotation, or for a bottle of something with a model that pours, by its name.
std::string substance_of(const std::string& tool, const Facts& facts, const SubstanceFacts& known) {
  std::string substance = facts.substances.empty() ? "" : *facts.substances.begin();
  const bool pours = facts.links.contains("fluidsource") || facts.links.contains("particleapplier");
  if (substance.empty() && (pours || known.squeezed.contains(tool)) && tool.starts_with("bottle_of_")) {
    substance = replace_all(tool.substr(std::string_view("bottle_of_").size()), "_", " ");
  }
  const auto word = known.words.find(substance);
  return word == known.words.end() ? substance : word->second;
}

/// Sauces and seasonings are spread over dishes and food of the usual kinds, soaps over what is washed up, other
/// cleaners over what is wiped.
void add_spreading(TableBuilder& builder, const Metadata& metadata, const std::set<std::string>& usual,
                   const SubstanceFacts& known) {
  for (const auto& tool : builder.names()) {
    const auto substance = substance_of(tool, metadata.categories.at(tool), known);
    const bool seasons = builder.is_kind(tool, KindGroup::Seasoning),
               cleans = builder.is_kind(tool, KindGroup::Cleaner);
    if (substance.empty() || !builder.has(tool, "pickupable") || (!seasons && !cleans)) continue;
    const bool soap = known.soaps.contains(substance);
    const auto kinds = seasons ? KindGroup::Seasoned : soap ? KindGroup::WashedUp : KindGroup::Cleaned;
    for (const auto& target : builder.names()) {
      if (!usual.contains(target) || target == tool || !builder.is_kind(target, kinds)) continue;
      if (builder.is_kind(target, KindGroup::Food)) builder.afford(target, "coverable", "curated", 0.8);
      if (!builder.has(target, "coverable")) continue;
      // One word, as formulas name it: (covered ?x dish_soap).
      const auto symbol = replace_all(substance, " ", "_");
      builder.effect({tool, Treatment::Dispenses, target, symbol, 0, {EffectNeed::Held}, {"curated", 0.8}});
    }
  }
}

/// Coffee machines fill the cup that stands under them, here on them.
void add_coffee(TableBuilder& builder) {
  for (const auto& tool : builder.names()) {
    if (!builder.is_kind(tool, KindGroup::Brewer) || !builder.has(tool, "switchable")) continue;
    for (const auto& target : builder.names()) {
      if (!builder.is_kind(target, KindGroup::Brewed) || !builder.has(target, "fillable")) continue;
      builder.effect(
          {tool, Treatment::Fills, target, "coffee", 0, {EffectNeed::PowerOn, EffectNeed::On}, {"curated", 0.9}});
    }
  }
}

}  // namespace

void add_effects(TableBuilder& builder, const Metadata& metadata, const Json& annotations, const Json& transitions,
                 const SubstanceFacts& known) {
  const auto listed = builder.curated_names();
  const std::set<std::string> usual(listed.begin(), listed.end());
  add_temperature(builder, metadata, annotations);
  add_washing(builder);
  add_coffee(builder);
  add_wiping(builder, usual);
  add_slicing(builder, metadata, transitions);
  add_spreading(builder, metadata, usual, known);
}

}  // namespace unietp::behavior
