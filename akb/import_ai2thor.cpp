#include <nlohmann/json.hpp>

#include <algorithm>

#include "akb/import_common.h"
#include "akb/importers.h"
#include "akb/metadata_json.h"
#include "akb/row_reader.h"
#include "akb/tables.h"
#include "akb/upstream_sizes.h"
#include "core/files.h"

namespace unietp {
namespace {

using Json = nlohmann::json;
const std::string kTypes = "metadata:object_types.json", kScenes = "metadata:ithor_scenes.json.gz",
                  kAssets = "metadata:procthor_asset_database.json.gz",
                  kReceptacles = "metadata:procthor_receptacles.json", kAlfred = "metadata:alfred_constants.json";

/// "breakable (Some)" -> "breakable" with less confidence.
void afford(TableBuilder& builder, const std::string& type, const std::string& property) {
  static const std::map<std::string, std::string> kNames{
      {"pickupable", "pickupable"}, {"openable", "openable"},   {"toggleable", "switchable"},
      {"sliceable", "sliceable"},   {"cookable", "cookable"},   {"dirtyable", "dirtyable"},
      {"fillable", "fillable"},     {"breakable", "breakable"}, {"usedUp", "consumable"}};
  const auto some = property.find(" (Some)");
  const auto name = kNames.find(property.substr(0, some));
  if (name != kNames.end()) builder.afford(type, name->second, kTypes, some == std::string::npos ? 1 : 0.7);
}

std::set<std::string> words(const Json& list) {
  std::set<std::string> names;
  for (const auto& item : list) names.insert(item.get<std::string>());
  names.erase("");
  return names;
}

bool listed(const Json& type, const char* field, const char* word) {
  const auto names = words(type.at(field));
  return names.contains(word);
}

struct SceneFacts {
  std::map<std::string, std::vector<double>> masses;
  std::map<std::string, std::vector<Vec3>> extents;
  std::map<std::pair<std::string, std::string>, int> held;  // object type, receptacle type
  std::map<std::string, int> number;                        // of objects of a type
  std::map<std::string, std::map<std::string, int>> alone;  // type, our word for a material: objects of it alone
};

/// Our word for one of AI2-THOR's salient materials; "" for what is none to tell a thing by: Food, Soap, Organic.
std::string material_of(const std::string& salient) {
  static const std::map<std::string, std::string> kWords{
      {"Ceramic", "ceramic"}, {"Fabric", "fabric"}, {"Glass", "glass"},     {"Leather", "leather"},
      {"Metal", "metal"},     {"Paper", "paper"},   {"Plastic", "plastic"}, {"Rubber", "rubber"},
      {"Sponge", "foam"},     {"Stone", "stone"},   {"Wax", "wax"},         {"Wood", "wood"}};
  const auto word = kWords.find(salient);
  return word == kWords.end() ? "" : word->second;
}

/// What things of a type come in: each material of which alone at least three and more than a tenth of its objects
/// are. Empty when that is none.
std::vector<std::string> materials_of(const std::string& type, const SceneFacts& facts) {
  constexpr int kLeast = 3, kRarest = 10;
  std::vector<std::string> materials;
  const auto alone = facts.alone.find(type);
  if (alone == facts.alone.end()) return materials;
  for (const auto& [material, number] : alone->second) {
    if (number >= kLeast && number * kRarest > facts.number.at(type)) materials.push_back(material);
  }
  return materials;
}

SceneFacts facts_of(const Json& scenes) {
  SceneFacts facts;
  for (const auto& [name, scene] : scenes.at("scenes").items()) {
    std::map<std::string, std::string> type_of;
    for (const auto& object : scene.at("objects")) type_of[object.at("objectId")] = object.at("objectType");
    for (const auto& object : scene.at("objects")) {
      const std::string type = object.at("objectType");
      ++facts.number[type];
      if (object.contains("materials") && object.at("materials").size() == 1) {
        const auto material = material_of(object.at("materials").at(0));
        if (!material.empty()) ++facts.alone[type][material];
      }
      // 1 kg is what Unity gives a body that nobody weighed.
      if (object.contains("mass") && object.at("mass") != 1) facts.masses[type].push_back(object.at("mass"));
      if (object.contains("aabbSize")) {
        const auto& s = object.at("aabbSize");
        facts.extents[type].emplace_back(s.at(0).get<double>(), s.at(2).get<double>(), s.at(1).get<double>());
      }
      if (!object.contains("parentReceptacles")) continue;
      for (const auto& parent : object.at("parentReceptacles")) {
        const auto holder = type_of.find(parent.get<std::string>());
        if (holder != type_of.end()) ++facts.held[{type, holder->second}];
      }
    }
  }
  return facts;
}

void add_categories(TableBuilder& builder, const Json& types, const std::vector<Asset>& assets,
                    const SceneFacts& facts) {
  std::map<std::string, std::vector<Vec3>> boxes;
  for (const auto& asset : assets) boxes[asset.category].push_back(asset.size);
  for (const auto& [type, row] : types.items()) {
    RawCategory raw;
    raw.name = type;
    raw.movable = listed(row, "actionable_properties", "pickupable");
    raw.source = {kTypes, 1};
    // Of furniture the metadata mostly names the frame: armchairs of metal.
    if (raw.movable) raw.materials = materials_of(type, facts);
    if (const auto own = boxes.find(type); own != boxes.end()) raw.extents = middle_box(own->second);
    raw.extents_source = kAssets;
    if (const auto seen = facts.extents.find(type); !raw.extents && seen != facts.extents.end()) {
      raw.extents = median(seen->second);
      raw.extents_source = kScenes;
    }
    if (const auto seen = facts.masses.find(type); seen != facts.masses.end()) {
      raw.mass = median(seen->second);
      raw.mass_source = kScenes;
    }
    builder.add(raw);
  }
  for (const auto& asset : assets) builder.model(asset);
}

/// A row of curated/ai2thor/appliances.csv: what a tool does to the types of a list of the metadata.
struct Appliance {
  std::string list, tool;
  Treatment treatment = Treatment::Heats;
  std::vector<EffectNeed> needs;
  double confidence = 1;
};

/// Errors: the first of the table.
Result<std::vector<Appliance>> read_appliances(const std::filesystem::path& path) {
  const auto text = read_file(path);
  if (!text) return text.error();
  std::vector<Error> errors;
  std::vector<std::string> names;
  for (const TreatmentInfo& treatment : all_treatments()) names.emplace_back(treatment.name);
  RowReader row(path.string(), *text, {"list", "tool", "effect", "needs", "confidence", "source"}, errors);
  std::vector<Appliance> appliances;
  for (const auto& cells : row.rows()) {
    row.at(cells);
    appliances.push_back({row.required("list"), row.required("tool"),
                          row.value_of("effect", names, "effect", treatment_named), read_needs(row),
                          row.number("confidence", 0, 1, false)});
    (void)row.required("source");
  }
  if (!errors.empty()) return errors.front();
  return appliances;
}

void add_affordances(TableBuilder& builder, const Json& types, const Json& alfred,
                     const std::vector<Appliance>& appliances) {
  const auto cools = [&](const std::string& type) {
    return std::any_of(appliances.begin(), appliances.end(),
                       [&](const Appliance& one) { return one.tool == type && one.treatment == Treatment::Cools; });
  };
  for (const auto& [type, row] : types.items()) {
    for (const auto& property : words(row.at("actionable_properties"))) afford(builder, type, property);
    // A receptacle that is hollow or slides out holds things inside: a toaster, a drawer.
    const auto* category = builder.find(type);
    if (category == nullptr) continue;
    const auto archetype = category->archetype;
    const bool hollow =
        archetype == Archetype::Vessel || (archetype == Archetype::Drawers && builder.has(type, "openable"));
    if (hollow && listed(row, "actionable_properties", "receptacle")) builder.afford(type, "container", kTypes, 0.9);
    if (listed(row, "materials_properties", "changeTemp")) {
      builder.afford(type, cools(type) ? "cold_source" : "heat_source", kTypes, 1);
    }
  }
  for (const auto& type : words(alfred.at("VAL_ACTION_OBJECTS").at("Heatable"))) {
    builder.afford(type, "heatable", kAlfred, 1);
  }
  builder.afford_by_archetype();
}

/// A receptacle that the metadata names holds an object inside when it is hollow, else on top; a chest's drawer counts
/// as inside only where the type can be opened.
Predicate relation_at(const TableBuilder& builder, const std::string& receptacle) {
  const auto archetype = builder.find(receptacle)->archetype;
  const bool drawers = archetype == Archetype::Drawers && builder.has(receptacle, "openable");
  return builder.has(receptacle, "container") || drawers ? Predicate::Inside : Predicate::On;
}

/// `built_in`: furniture that stands in other furniture.
void add_placements(TableBuilder& builder, const Json& types, const Json& receptacles, const SceneFacts& facts,
                    const NameTexts& built_in) {
  for (const auto& [type, row] : types.items()) {
    for (const auto& receptacle : words(row.at("compatible_receptacles"))) {
      if (builder.find(receptacle)) builder.seen(type, relation_at(builder, receptacle), receptacle, 0.5, kTypes);
    }
  }
  // The dumps also count what hangs over a surface as on it: a window over a counter.
  const auto sensible = builder.sensible_placements();
  for (const auto& [pair, count] : facts.held) {
    const auto& [object, receptacle] = pair;
    if (!builder.find(object) || !builder.find(receptacle) || receptacle == "Floor") continue;
    const auto relation = relation_at(builder, receptacle);
    if (!builder.find(object)->movable && !built_in.contains(object) &&
        !sensible.contains({object, relation, receptacle}))
      continue;
    builder.seen(object, relation, receptacle, 0.2 * count, kScenes);
  }
  for (const auto& [receptacle, objects] : receptacles.items()) {
    if (!builder.find(receptacle)) continue;
    for (const auto& [object, row] : objects.items()) {
      if (builder.find(object)) {
        builder.seen(object, relation_at(builder, receptacle), receptacle, 4 * row.at("p").get<double>(), kReceptacles);
      }
    }
  }
  builder.place_by_kind(0.05);
}

/// What follows from lists of the metadata, of ALFRED's and of what gets dirty; the other effects stand in
/// curated/ai2thor/effect.csv.
void add_effects(TableBuilder& builder, const Json& types, const Json& alfred,
                 const std::vector<Appliance>& appliances) {
  const auto& actions = alfred.at("VAL_ACTION_OBJECTS");
  for (const Appliance& one : appliances) {
    const auto add = [&](const std::string& target) {
      builder.effect({one.tool, one.treatment, target, "", 0, one.needs, {kAlfred, one.confidence}});
    };
    if (actions.contains(one.list)) {
      for (const auto& type : words(actions.at(one.list))) add(type);
      continue;
    }
    for (const auto& [type, row] : types.items()) {
      if (builder.has(type, "pickupable") && builder.has(type, one.list)) add(type);
    }
  }
}

}  // namespace

Result<Tables> import_ai2thor(const std::filesystem::path& upstream, const std::filesystem::path& curated,
                              const AbsurdPlace& absurd) {
  const auto folder = upstream / "ai2thor";
  const auto types = read_metadata_json(folder / "object_types.json");
  if (!types) return types.error();
  const auto scenes = read_metadata_json(folder / "ithor_scenes.json.gz");
  if (!scenes) return scenes.error();
  const auto assets = read_procthor_assets(upstream);
  if (!assets) return assets.error();
  const auto receptacles = read_metadata_json(folder / "procthor_receptacles.json");
  if (!receptacles) return receptacles.error();
  const auto alfred = read_metadata_json(folder / "alfred_constants.json");
  if (!alfred) return alfred.error();

  const auto built_in = read_name_texts(curated / "ai2thor" / "built_in.csv");
  if (!built_in) return built_in.error();

  const auto appliances = read_appliances(curated / "ai2thor" / "appliances.csv");
  if (!appliances) return appliances.error();

  TableBuilder builder(Simulator::Ai2thor, curated);
  builder.refuse(absurd);
  const auto facts = facts_of(*scenes);
  add_categories(builder, *types, *assets, facts);
  add_affordances(builder, *types, *alfred, *appliances);
  add_placements(builder, *types, *receptacles, facts, *built_in);
  add_effects(builder, *types, *alfred, *appliances);
  return builder.finish();
}

}  // namespace unietp
