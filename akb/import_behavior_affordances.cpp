#include <nlohmann/json.hpp>

#include "akb/import_behavior.h"

namespace unietp::behavior {
namespace {

using Json = nlohmann::json;

bool has_door(Archetype archetype) {
  return archetype == Archetype::Cabinet || archetype == Archetype::Drawers || archetype == Archetype::Lidded ||
         archetype == Archetype::Folding;
}

}  // namespace

bool opens(const Facts& facts) { return facts.links.contains("joint") && facts.properties.contains("openable"); }

namespace {

void add_of(TableBuilder& builder, const std::string& name, const Facts& f, bool sliced) {
  static const std::map<std::string, std::string> kProperties{
      {"cookable", "cookable"},      {"breakable", "breakable"}, {"heatSource", "heat_source"},
      {"coldSource", "cold_source"}, {"particleSink", "drain"},  {"drapeable", "foldable"}};
  const auto& c = *builder.find(name);
  const auto afford = [&](const std::string& affordance, const std::string& source, double confidence) {
    if (!f.denied.contains(affordance)) builder.afford(name, affordance, source, confidence);
  };
  if (c.movable) builder.afford(name, "pickupable", "derived:not-scene-object", 0.9);
  if (has_door(c.archetype) && opens(f)) {
    builder.afford(name, "openable", kInventory, 1);
    if (c.archetype == Archetype::Drawers) builder.afford(name, "container", kInventory, 0.9);
  }
  // What sprays, shakes or pours is used by hand, not switched on and left to run; a tap is.
  const bool by_hand = c.movable && (f.links.contains("particleapplier") || f.links.contains("fluidsource"));
  if (f.links.contains("togglebutton") && f.properties.contains("toggleable") && !by_hand) {
    builder.afford(name, "switchable", kInventory, 1);
  }
  for (const auto& [property, affordance] : kProperties) {
    if (f.properties.contains(property)) afford(affordance, kAnnotations, 1);
  }
  if (f.properties.contains("sliceable") && sliced) {
    builder.afford(name, "sliceable", kAnnotations, 1);
  }
  if (f.properties.contains("cookable")) afford("burnable", kAnnotations, 0.9);
  const auto kind_only = [&](KindGroup kinds, const char* property, const char* affordance) {
    if (builder.is_kind(name, kinds) && f.properties.contains(property)) {
      afford(affordance, kAnnotations, 0.9);
    }
  };
  kind_only(KindGroup::Food, "heatable", "heatable");
  kind_only(KindGroup::HeatedVessel, "heatable", "heatable");
  kind_only(KindGroup::Food, "freezable", "freezable");
  kind_only(KindGroup::Dirtied, "stainable", "dirtyable");
  kind_only(KindGroup::Dirtied, "stainable", "coverable");
  kind_only(KindGroup::Filled, "fillable", "fillable");
  if (c.movable && f.links.contains("fluidsource") &&
      builder.is_kind(name, KindGroup::Filled))  // what pours was filled
    afford("fillable", kInventory, 0.9);
  kind_only(KindGroup::Soaked, "particleRemover", "soakable");
}

}  // namespace

std::map<std::string, Pieces> pieces_of(const TableBuilder& builder, const Metadata& metadata,
                                        const Json& transitions) {
  std::map<std::string, std::vector<std::string>> of_synset;
  for (const auto& name : builder.names()) of_synset[metadata.categories.at(name).synset].push_back(name);
  std::map<std::string, Pieces> pieces;
  for (const auto& rule : transitions.at("slicing")) {
    for (const auto& [whole_synset, count] : rule.at("input_synsets").items()) {
      for (const auto& [piece_synset, amount] : rule.at("output_synsets").items()) {
        if (of_synset[piece_synset].empty()) continue;
        const auto& piece = of_synset[piece_synset].front();
        for (const auto& whole : of_synset[whole_synset]) {
          // A quail's leg is of the quail's synset too, but lighter than half a breast.
          if (builder.find(piece)->mass <= builder.find(whole)->mass) pieces[whole] = {piece, amount.get<int>()};
        }
      }
    }
  }
  return pieces;
}

void add_affordances(TableBuilder& builder, const Metadata& metadata, const Json& transitions) {
  const auto pieces = pieces_of(builder, metadata, transitions);
  for (const auto& name : builder.names()) {
    add_of(builder, name, metadata.categories.at(name), pieces.contains(name));
  }
  builder.afford_by_archetype();
}

}  // namespace unietp::behavior
