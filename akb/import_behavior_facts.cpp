#include <nlohmann/json.hpp>

#include <algorithm>

#include "akb/import_behavior.h"
#include "akb/metadata_json.h"
#include "akb/row_reader.h"
#include "akb/table_words.h"
#include "core/files.h"
#include "core/text.h"

namespace unietp::behavior {
namespace {

using Json = nlohmann::json;

std::map<std::string, std::size_t> columns_in(const CsvFile& file) {
  std::map<std::string, std::size_t> column;
  for (std::size_t i = 0; i < file.header.size(); ++i) column.try_emplace(file.header[i].text, i);
  return column;
}

double number_of(std::string text) {
  text.erase(std::remove(text.begin(), text.end(), ','), text.end());
  return text.empty() ? 0 : std::stod(text);
}

void add_properties(Facts& facts, const Json& annotations) {
  if (!annotations.contains(facts.synset)) return;
  for (const auto& [property, parameters] : annotations.at(facts.synset).items()) {
    facts.properties.insert(property);
    if ((property != "particleApplier" && property != "particleSource") || !parameters.is_object()) continue;
    if (!parameters.contains("conditions") || !parameters.at("conditions").is_object()) continue;
    for (const auto& [substance, conditions] : parameters.at("conditions").items()) {
      facts.substances.insert(replace_all(substance.substr(0, substance.find('.')), "_", " "));
    }
  }
}

void add_models(Metadata& metadata, const Json& inventory) {
  for (const auto& [model, row] : inventory.at("objects").items()) {
    const auto found = metadata.categories.find(model.substr(0, model.rfind('-')));
    if (found == metadata.categories.end()) continue;
    const auto& size = row.at("size");  // upstream's front faces along x
    found->second.models.emplace_back(
        model, Vec3(size.at(1).get<double>(), size.at(0).get<double>(), size.at(2).get<double>()));
    for (const auto& link : row.at("meta_links")) found->second.links.insert(link.get<std::string>());
  }
}

/// The tree's first way up from each synset. Not recursive: a file decides how deep the tree is.
void add_hypernyms(Metadata& metadata, const Json& root) {
  std::vector<std::pair<const Json*, std::string>> open{
      {&root, ""}};  // nodes and what is above them, the next one last
  while (!open.empty()) {
    const auto [node, above] = std::move(open.back());
    open.pop_back();
    const auto& name = node->at("name").get_ref<const std::string&>();
    if (!above.empty()) metadata.hypernym.try_emplace(name, above);
    if (!node->contains("children")) continue;
    const Json& children = node->at("children");
    for (std::size_t i = children.size(); i-- > 0;) open.emplace_back(&children.at(i), name);
  }
}

/// Our own lists about BEHAVIOR's scenes.
struct SceneLists {
  NameTexts rooms;     // our type of room, by BEHAVIOR's
  NameTexts no_homes;  // scenes, by their whole names or first words
};

/// Our room type for an instance of BEHAVIOR's, "" for what homes need not have.
std::string room_type_of(const std::string& instance, const SceneLists& lists) {
  const auto found = lists.rooms.find(instance.substr(0, instance.rfind('_')));
  return found == lists.rooms.end() ? "" : found->second;
}

bool is_home(const std::string& scene, const SceneLists& lists) {
  return !lists.no_homes.contains(scene.substr(0, scene.find('_'))) && !lists.no_homes.contains(scene);
}

/// Rooms with at least a fifth of what a home's rooms hold of the category, given there are five of it.
void add_rooms(Metadata& metadata, const Json& scenes, const SceneLists& lists) {
  constexpr int kSeen = 5, kShare = 5;
  std::map<std::string, std::map<std::string, int>> seen;
  for (const auto& [scene, rooms] : scenes.at("scenes").items()) {
    if (!is_home(scene, lists)) continue;
    for (const auto& [instance, objects] : rooms.items()) {
      const auto type = room_type_of(instance, lists);
      if (type.empty()) continue;
      for (const auto& [model, count] : objects.items())
        seen[model.substr(0, model.rfind('-'))][type] += count.get<int>();
    }
  }
  for (auto& [name, facts] : metadata.categories) {
    int total = 0;
    std::vector<std::pair<int, std::string>> rooms;
    for (const auto& [type, count] : seen[name]) {
      total += count;
      rooms.emplace_back(-count, type);
    }
    std::sort(rooms.begin(), rooms.end());
    for (const auto& [count, type] : rooms) {
      if (total >= kSeen && -count * kShare >= total) facts.rooms.push_back(type);
    }
  }
}

/// denied.csv: affordances that the annotations of a synset give and things of these categories lack.
std::optional<Error> read_denied(Metadata& metadata, const std::filesystem::path& path) {
  const auto text = read_file(path);
  if (!text) return text.error();
  std::vector<Error> errors;
  RowReader row(path.string(), *text, {"affordance", "categories", "reason"}, errors);
  for (const auto& cells : row.rows()) {
    row.at(cells);
    const auto& affordance = row.one_of("affordance", affordance_names(), "affordance");
    for (const auto& name : row.list("categories")) {
      const auto found = metadata.categories.find(name);
      if (found == metadata.categories.end()) row.fail("categories", "no '" + name + "' in the metadata");
      if (found != metadata.categories.end()) found->second.denied.insert(affordance);
    }
  }
  return errors.empty() ? std::nullopt : std::optional(errors.front());
}

/// masses.csv: masses in kilograms of things whose mass in category_mapping.csv nobody would believe, such as a pair's.
std::optional<Error> read_masses(Metadata& metadata, const std::filesystem::path& path) {
  std::vector<Error> errors;
  each_row(path, {"name", "mass"}, errors, [&](RowReader& row) {
    const auto found = metadata.categories.find(row.text("name"));
    const double mass = row.number("mass", 0.001, 100, true);
    if (found == metadata.categories.end()) return row.fail("name", "no '" + row.text("name") + "' in the metadata");
    found->second.mass = mass;
    found->second.weighed = true;
  });
  return errors.empty() ? std::nullopt : std::optional(errors.front());
}

}  // namespace

Result<Metadata> read_behavior(const std::filesystem::path& folder, const std::filesystem::path& curated,
                               const Json& annotations) {
  const auto mapping = read_metadata_csv(folder / "category_mapping.csv.gz");
  if (!mapping) return mapping.error();
  const auto hierarchy = read_metadata_json(folder / "output_hierarchy.json.gz");
  if (!hierarchy) return hierarchy.error();
  const auto inventory = read_metadata_json(folder / "object_inventory.json.gz");
  if (!inventory) return inventory.error();
  const auto scenes = read_metadata_json(folder / "combined_room_object_list.json.gz");
  if (!scenes) return scenes.error();

  const auto inventory_only = read_name_texts(curated / "inventory.csv");
  if (!inventory_only) return inventory_only.error();
  const auto rooms = read_name_texts(curated / "rooms.csv");
  if (!rooms) return rooms.error();
  const auto no_homes = read_name_texts(curated / "no_homes.csv");
  if (!no_homes) return no_homes.error();

  Metadata metadata;
  const auto column = columns_in(*mapping);
  for (const auto& row : mapping->rows) {
    if (row[column.at("has_system")].text != "FALSE") continue;  // a substance
    Facts& facts = metadata.categories[row[column.at("category")].text];
    facts.synset = row[column.at("synset")].text;
    facts.mass = number_of(row[column.at("mass (auto)")].text);
  }
  // The mapping is of an older release than the inventory.
  for (const auto& [name, synset] : *inventory_only) metadata.categories[name].synset = synset;
  add_hypernyms(metadata, *hierarchy);
  for (auto& [name, facts] : metadata.categories) add_properties(facts, annotations);
  add_models(metadata, *inventory);
  add_rooms(metadata, *scenes, {*rooms, *no_homes});
  if (const auto error = read_denied(metadata, curated / "denied.csv")) return *error;
  if (const auto error = read_masses(metadata, curated / "masses.csv")) return *error;
  return metadata;
}

}  // namespace unietp::behavior
