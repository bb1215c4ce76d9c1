#include <nlohmann/json.hpp>

#include "akb/import_common.h"
#include "akb/importers.h"
#include "akb/metadata_json.h"
#include "core/text.h"

namespace unietp {
namespace {

using Json = nlohmann::json;
const std::string kProperties = "metadata:properties_data_unity.json", kScript = "metadata:properties_data.json",
                  kPrefabs = "metadata:prefabs_dims.json.gz", kClasses = "metadata:PrefabClass.json",
                  kPlacing = "metadata:object_script_placing.json.gz", kScenePlaces = "metadata:scenes";

/// Prefab names of each class, under the class name without capitals.
std::map<std::string, std::vector<std::string>> prefabs_of(const Json& classes) {
  std::map<std::string, std::vector<std::string>> prefabs;
  for (const auto& row : classes.at("prefabClasses")) {
    for (const auto& prefab : row.at("prefabs")) {
      prefabs[lower(row.at("className").get<std::string>())].push_back(prefab.get<std::string>());
    }
  }
  return prefabs;
}

/// Boxes of the prefabs of a class. Upstream says nothing of fronts: most lie along x, so that z is the width.
std::map<std::string, Vec3> boxes_of(const std::vector<std::string>& prefabs, const Json& dims) {
  std::map<std::string, Vec3> boxes;
  for (const auto& prefab : prefabs) {
    if (!dims.contains(prefab)) continue;
    const auto& size = dims.at(prefab).at("size");
    const Vec3 box(size.at(2).get<double>(), size.at(0).get<double>(), size.at(1).get<double>());
    if (box.minCoeff() > 0) boxes.emplace(prefab, box);
  }
  return boxes;
}

/// The box with its long side across where the category's is.
Vec3 laid_level(const Vec3& box, const Vec3& category) {
  const bool same = (box.x() >= box.y()) == (category.x() >= category.y());
  return same ? box : Vec3(box.y(), box.x(), box.z());
}

void add_category(TableBuilder& builder, RawCategory raw, const std::map<std::string, Vec3>& boxes) {
  std::vector<Vec3> all;
  for (const auto& [prefab, box] : boxes) all.push_back(box);
  if (!all.empty()) raw.extents = middle_box(all);
  raw.extents_source = kPrefabs;
  builder.add(raw);
  const auto* category = builder.find(raw.name);
  if (category == nullptr) return;
  for (const auto& [prefab, box] : boxes) {
    builder.model({prefab, raw.name, laid_level(box, category->size), {kPrefabs, 0.9}});
  }
}

/// Classes by the names that the script world gives them.
class ScriptNames {
 public:
  ScriptNames(const TableBuilder& builder, NameTexts others) : builder_(builder), others_(std::move(others)) {}

  /// "kitchen_counter" -> "kitchencounter"; empty when no class has that name.
  std::string class_named(const std::string& script_name) const {
    auto plain = replace_all(script_name, "_", "");
    if (builder_.find(plain)) return plain;
    const auto other = others_.find(script_name);
    return other != others_.end() && builder_.find(other->second) ? other->second : std::string();
  }

 private:
  const TableBuilder& builder_;
  NameTexts others_;
};

using Placements = std::set<std::tuple<std::string, Predicate, std::string>>;

/// What the script world adds: where one can lie down, and what has a plug.
void add_script_affordances(TableBuilder& builder, const ScriptNames& names, const Json& properties) {
  static const std::map<std::string, std::string> kNames{
      {"SITTABLE", "sittable"}, {"LIEABLE", "lieable"}, {"HAS_PLUG", "pluggable"}};
  for (const auto& [name, list] : properties.items()) {
    for (const auto& property : list) {
      const auto affordance = kNames.find(property.get<std::string>());
      if (affordance != kNames.end()) builder.afford(names.class_named(name), affordance->second, kScript, 0.9);
    }
  }
}

/// What the script world or a scene says is kept in place only where a rule of ours calls it common sense; such a pair
/// then weighs more than one that only the rule knows. Otherwise a water glass on a rug would pass.
void confirm(TableBuilder& builder, const Placements& sensible, const std::string& object,
             const std::string& receptacle, double weight, const std::string& source) {
  for (const Predicate relation : {Predicate::Inside, Predicate::On}) {
    if (!sensible.contains({object, relation, receptacle})) continue;
    builder.seen(object, relation, receptacle, weight, source);
    return;
  }
}

void add_affordances(TableBuilder& builder, const Json& properties) {
  static const std::map<std::string, std::string> kNames{{"GRABBABLE", "pickupable"}, {"SURFACES", "receptacle"},
                                                         {"CONTAINERS", "container"}, {"HAS_SWITCH", "switchable"},
                                                         {"CAN_OPEN", "openable"},    {"SITTABLE", "sittable"}};
  for (const auto& [name, list] : properties.items()) {
    const auto* category = builder.find(name);
    if (category == nullptr) continue;
    for (const auto& property : list) {
      const auto affordance = kNames.find(property.get<std::string>());
      if (affordance == kNames.end()) continue;
      // Upstream marks ceiling lamps, rugs and pictures GRABBABLE; a curated `movable,false` overrules that.
      if (affordance->second == "pickupable" && !category->movable) continue;
      const bool open_shelf = affordance->second == "container" && category->archetype == Archetype::Shelf;
      const bool flat = affordance->second == "container" && category->archetype == Archetype::Plate;
      builder.afford(name, open_shelf || flat ? "receptacle" : affordance->second, kProperties, 1);
    }
  }
  builder.afford_by_archetype();
}

}  // namespace

Result<Tables> import_virtualhome(const std::filesystem::path& upstream, const std::filesystem::path& curated,
                                  const AbsurdPlace& absurd) {
  const auto folder = upstream / "virtualhome";
  const auto properties = read_metadata_json(folder / "properties_data_unity.json");
  if (!properties) return properties.error();
  const auto script = read_metadata_json(folder / "properties_data.json");
  if (!script) return script.error();
  const auto classes = read_metadata_json(folder / "PrefabClass.json");
  if (!classes) return classes.error();
  const auto dims = read_metadata_json(folder / "prefabs_dims.json.gz");
  if (!dims) return dims.error();
  const auto placing = read_metadata_json(folder / "object_script_placing.json.gz");
  if (!placing) return placing.error();
  std::vector<Json> scenes;
  for (int i = 1; i <= 6; ++i) {
    auto scene = read_metadata_json(folder / "scenes" / ("TestScene" + std::to_string(i) + ".json.gz"));
    if (!scene) return scene.error();
    scenes.push_back(std::move(*scene));
  }

  const auto script_names = read_name_texts(curated / "virtualhome" / "script_names.csv");
  if (!script_names) return script_names.error();
  const auto further = read_name_texts(curated / "virtualhome" / "further_classes.csv");
  if (!further) return further.error();

  TableBuilder builder(Simulator::Virtualhome, curated);
  builder.refuse(absurd);
  const auto prefabs = prefabs_of(*classes);
  const auto add = [&](const std::string& name, bool grabbable, const std::string& source) {
    RawCategory raw;
    raw.name = name;
    raw.movable = grabbable;
    raw.source = {source, 1};
    const auto own = prefabs.find(name);
    add_category(builder, raw, own == prefabs.end() ? std::map<std::string, Vec3>{} : boxes_of(own->second, *dims));
  };
  for (const auto& [name, list] : properties->items()) {
    add(name, std::find(list.begin(), list.end(), "GRABBABLE") != list.end(), kProperties);
  }
  // The only classes of PrefabClass.json outside the table above that stand in the apartments and are no structure.
  for (const auto& [name, movable] : *further) add(name, movable == "true", kClasses);
  const ScriptNames names(builder, *script_names);
  add_script_affordances(builder, names, *script);
  add_affordances(builder, *properties);

  const auto sensible = builder.sensible_placements();
  for (const auto& [object, list] : placing->items()) {
    for (const auto& place : list) {
      const auto thing = names.class_named(object);
      const auto receptacle = names.class_named(place.at("destination").get<std::string>());
      if (!thing.empty() && !receptacle.empty()) confirm(builder, sensible, thing, receptacle, 1, kPlacing);
    }
  }
  for (const auto& scene : scenes) {
    std::map<int, std::string> class_of;
    for (const auto& node : scene.at("nodes")) class_of[node.at("id")] = node.at("class_name");
    for (const auto& edge : scene.at("edges")) {
      const auto relation = edge.at(1).get<std::string>();
      if (relation != "ON" && relation != "INSIDE") continue;
      confirm(builder, sensible, class_of[edge.at(0)], class_of[edge.at(2)], 0.5, kScenePlaces);
    }
  }
  builder.place_by_kind(0.4);
  return builder.finish();
}

}  // namespace unietp
