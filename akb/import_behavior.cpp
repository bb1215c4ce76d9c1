#include <nlohmann/json.hpp>

#include <algorithm>

#include "akb/import_common.h"
#include "akb/importers.h"
#include "akb/metadata_json.h"

namespace unietp {
namespace {

using Json = nlohmann::json;
const std::string kTable = "metadata:category_mapping.csv.gz",
                  kAnnotations = "metadata:propagated_annots_params.json.gz",
                  kInventory = "metadata:object_inventory.json.gz", kSlicing = "metadata:transition_maps.json.gz";
constexpr double kHeaviestPick_kg = 15, kLargestPick_m = 1.0;

/// One category as the annotation tables describe it.
struct Facts {
  std::string synset;
  std::optional<double> mass;
  std::vector<Vec3> extents;         // of its models
  std::set<std::string> properties;  // of its synset
  std::set<std::string> links;       // of any of its models: joint, togglebutton, fillable, ...
};

/// category -> synset and mass from category_mapping.csv.
std::map<std::string, Facts> facts_of(const CsvFile& mapping, const Json& annotations, const Json& inventory) {
  std::map<std::string, std::size_t> column;
  for (std::size_t i = 0; i < mapping.header.size(); ++i) column[mapping.header[i].text] = i;
  std::map<std::string, Facts> facts;
  for (const auto& row : mapping.rows) {
    auto& f = facts[row[column.at("category")].text];
    f.synset = row[column.at("synset")].text;
    auto mass = row[column.at("mass (auto)")].text;
    mass.erase(std::remove(mass.begin(), mass.end(), ','), mass.end());
    if (!mass.empty()) f.mass = std::stod(mass);
    if (!annotations.contains(f.synset)) continue;
    for (const auto& [property, parameters] : annotations.at(f.synset).items()) f.properties.insert(property);
  }
  for (const auto& [model, row] : inventory.at("objects").items()) {
    const auto found = facts.find(model.substr(0, model.rfind('-')));
    if (found == facts.end()) continue;
    const auto& size = row.at("size");
    found->second.extents.emplace_back(size.at(1).get<double>(), size.at(0).get<double>(), size.at(2).get<double>());
    for (const auto& link : row.at("meta_links")) found->second.links.insert(link.get<std::string>());
  }
  return facts;
}

void add_affordances(TableBuilder& builder, const std::map<std::string, Facts>& facts) {
  static const std::map<std::string, std::string> kProperties{
      {"sliceable", "sliceable"},    {"cookable", "cookable"},      {"breakable", "breakable"},
      {"heatSource", "heat_source"}, {"coldSource", "cold_source"}, {"particleSink", "drain"},
      {"drapeable", "foldable"}};
  static const std::set<std::string> kFood{"fruit", "big_fruit", "bakery", "meal", "meat", "slice"};
  static const std::set<std::string> kTemperature{"fruit", "big_fruit", "bakery",    "meal",  "meat",
                                                  "slice", "cup",       "bowl",      "plate", "pot",
                                                  "drink", "kettle",    "lunch_box", "pan"};
  static const std::set<std::string> kDirty{"plate",      "bowl",    "cup",          "cutlery",      "pan",
                                            "pot",        "tray",    "utensil",      "cloth",        "clothes",
                                            "kettle",     "counter", "dining_table", "coffee_table", "desk",
                                            "side_table", "sink",    "bathtub",      "lunch_box"};
  static const std::set<std::string> kFill{"cup", "bowl", "pot", "kettle", "pitcher", "bucket", "vase"};
  for (const auto& name : builder.names()) {
    const auto& c = *builder.find(name);
    const auto& f = facts.at(name);
    if (c.movable) builder.afford(name, "pickupable", "derived:not-scene-object", 0.9);
    const bool has_door = c.archetype == Archetype::Cabinet || c.archetype == Archetype::Drawers ||
                          c.archetype == Archetype::Lidded || c.archetype == Archetype::Folding;
    if (has_door && f.links.contains("joint")) {
      builder.afford(name, "openable", kInventory, 1);
      if (c.archetype == Archetype::Drawers) builder.afford(name, "container", kInventory, 0.9);
    }
    const bool shaker = builder.is_kind(name, {"condiment", "toiletry", "cleaning_bottle"});
    if (f.links.contains("togglebutton") && f.properties.contains("toggleable") && !shaker) {
      builder.afford(name, "switchable", kInventory, 1);
    }
    for (const auto& [property, affordance] : kProperties) {
      if (f.properties.contains(property)) builder.afford(name, affordance, kAnnotations, 1);
    }
    if (f.properties.contains("cookable")) builder.afford(name, "burnable", kAnnotations, 0.9);
    const auto kind_only = [&](const std::set<std::string>& kinds, const char* property, const char* affordance) {
      if (builder.is_kind(name, kinds) && f.properties.contains(property)) {
        builder.afford(name, affordance, kAnnotations, 0.9);
      }
    };
    kind_only(kTemperature, "heatable", "heatable");
    kind_only(kFood, "freezable", "freezable");
    kind_only(kDirty, "stainable", "dirtyable");
    kind_only(kDirty, "stainable", "coverable");
    kind_only(kFill, "fillable", "fillable");
    kind_only({"cloth", "cleaning"}, "particleRemover", "soakable");
  }
  builder.afford_by_archetype();
}

std::vector<std::string> needs_of(const Json& source) {
  std::vector<std::string> needs;
  if (source.value("requires_closed", 0.0) > 0) needs.emplace_back("closed");
  if (source.value("requires_toggled_on", 0.0) > 0) needs.emplace_back("power_on");
  needs.emplace_back(source.value("requires_inside", 0.0) > 0 ? "inside" : "on");
  return needs;
}

void add_temperature(TableBuilder& builder, const std::map<std::string, Facts>& facts, const Json& annotations) {
  for (const auto& tool : builder.names()) {
    const auto& synset = facts.at(tool).synset;
    if (!annotations.contains(synset)) continue;
    const auto& properties = annotations.at(synset);
    for (const auto& target : builder.names()) {
      if (!builder.has(target, "pickupable")) continue;
      const auto add = [&](const char* effect, const Json& source) {
        builder.effect({tool, effect, target, "", 0, needs_of(source), {kAnnotations, 1}});
      };
      if (properties.contains("heatSource") && builder.has(tool, "switchable")) {
        const auto& source = properties.at("heatSource");
        const bool kitchen = builder.is_kind(tool, {"oven", "stove", "microwave"});
        // An open flame burns food that lies on it, a closed oven cooks it.
        const bool flame = builder.is_kind(tool, {"stove"}), burns = flame && builder.has(target, "burnable");
        if (burns) add("burns", source);
        if (kitchen && !burns && builder.has(target, "heatable")) add("heats", source);
        if (kitchen && !flame && builder.has(target, "cookable")) add("cooks", source);
      }
      if (properties.contains("coldSource") && builder.is_kind(tool, {"fridge", "freezer", "cooler"})) {
        const auto& source = properties.at("coldSource");
        if (builder.has(target, "heatable")) add("cools", source);
        if (builder.has(target, "freezable") && source.value("temperature", 0.0) < 0) add("freezes", source);
      }
    }
  }
}

void add_cleaning(TableBuilder& builder) {
  const Source curated{"curated", 0.9};
  for (const auto& tool : builder.names()) {
    for (const auto& target : builder.names()) {
      if (tool == target) continue;
      const bool movable = builder.has(target, "pickupable"), dirty = builder.has(target, "dirtyable");
      const auto add = [&](const char* effect, const char* gives, std::vector<std::string> needs) {
        builder.effect({tool, effect, target, gives, 0, std::move(needs), curated});
      };
      const bool cloth = builder.is_kind(target, {"cloth", "clothes"});
      if (builder.is_kind(tool, {"sink"})) {
        if (movable && dirty) add("washes", "", {"under_tap"});
        if (movable && builder.has(target, "fillable")) add("fills", "water", {"under_tap"});
        if (movable && builder.has(target, "fillable")) add("drains", "", {});
        if (movable && builder.has(target, "soakable")) add("soaks", "water", {"under_tap"});
      }
      if (builder.is_kind(tool, {"dishwasher"}) && movable && dirty && !cloth) {
        add("washes", "", {"closed", "power_on", "inside"});
      }
      if (builder.is_kind(tool, {"washer"}) && movable && dirty && cloth) {
        add("washes", "", {"closed", "power_on", "inside"});
      }
      if (builder.has(tool, "soakable") && builder.has(target, "coverable") && !cloth) add("wipes", "", {"held"});
    }
  }
}

void add_slicing(TableBuilder& builder, const std::map<std::string, Facts>& facts, const Json& rules) {
  std::map<std::string, std::string> category_of;  // synset -> our category
  for (const auto& name : builder.names()) category_of.try_emplace(facts.at(name).synset, name);
  for (const auto& rule : rules.at("slicing")) {
    for (const auto& [whole, count] : rule.at("input_synsets").items()) {
      for (const auto& [piece, amount] : rule.at("output_synsets").items()) {
        for (const auto& tool : builder.names()) {
          if (!facts.at(tool).properties.contains("slicer")) continue;
          builder.effect(
              {tool, "slices", category_of[whole], category_of[piece], amount.get<int>(), {"held"}, {kSlicing, 1}});
        }
      }
    }
  }
}

void add_spreading(TableBuilder& builder) {
  static const std::map<std::string, std::string> kSubstance{{"salt_shaker", "salt"},
                                                             {"pepper_shaker", "pepper"},
                                                             {"bottle_of_catsup", "ketchup"},
                                                             {"bottle_of_mustard", "mustard"},
                                                             {"bottle_of_soy_sauce", "soy sauce"},
                                                             {"bottle_of_olive_oil", "olive oil"},
                                                             {"bottle_of_chocolate_sauce", "chocolate sauce"}};
  for (const auto& [tool, substance] : kSubstance) {
    for (const auto& target : builder.names()) {
      if (builder.is_kind(target, {"plate", "meat", "bowl", "pan", "counter", "dining_table"})) {
        if (!builder.has(target, "coverable") && builder.kind(target) == "meat") {
          builder.afford(target, "coverable", "curated", 0.8);
        }
        builder.effect({tool, "dispenses", target, substance, 0, {"held"}, {"curated", 0.8}});
      }
    }
  }
}

}  // namespace

Result<Tables> import_behavior(const std::filesystem::path& upstream, const std::filesystem::path& curated) {
  const auto folder = upstream / "behavior";
  const auto mapping = read_metadata_csv(folder / "category_mapping.csv.gz");
  if (!mapping) return mapping.error();
  const auto annotations = read_metadata_json(folder / "propagated_annots_params.json.gz");
  if (!annotations) return annotations.error();
  const auto inventory = read_metadata_json(folder / "object_inventory.json.gz");
  if (!inventory) return inventory.error();
  const auto rules = read_metadata_json(folder / "transition_maps.json.gz");
  if (!rules) return rules.error();

  TableBuilder builder(Simulator::Behavior, curated);
  const auto facts = facts_of(*mapping, *annotations, *inventory);
  for (const auto& name : builder.curated_names()) {
    const auto found = facts.find(name);
    if (found == facts.end()) {
      return Error{Error::Kind::Schema,
                   (curated / "behavior" / "category.csv").string(),
                   {},
                   "no BEHAVIOR category '" + name + "'; expected one of category_mapping.csv"};
    }
    const Facts& f = found->second;
    RawCategory raw;
    raw.name = name;
    if (!f.extents.empty()) raw.extents = median(f.extents);
    raw.extents_source = kInventory;
    raw.mass = f.mass;
    raw.mass_source = kTable;
    raw.source = {kTable, 1};
    raw.movable = !f.properties.contains("sceneObject") && f.mass.value_or(0) <= kHeaviestPick_kg &&
                  (!raw.extents || raw.extents->maxCoeff() <= kLargestPick_m);
    builder.add(raw);
  }
  add_affordances(builder, facts);
  builder.place_by_kind(1);
  add_temperature(builder, facts, *annotations);
  add_cleaning(builder);
  add_slicing(builder, facts, *rules);
  add_spreading(builder);
  return builder.finish();
}

}  // namespace unietp
