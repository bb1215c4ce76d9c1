#include "interchange/scene_models.h"

#include <algorithm>
#include <cctype>

#include <nlohmann/json.hpp>

#include "akb/csv.h"
#include "core/limits.h"
#include "core/text.h"
#include "interchange/foreign_json.h"
#include "scene/json_parse.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

/// HSSD names its models by hashes, and parts of them "<hash>_part_3".
bool is_hash(std::string_view name) {
  constexpr std::size_t kShortest = 24;
  const std::string_view first = name.substr(0, name.find('_'));
  return first.size() >= kShortest &&
         std::all_of(first.begin(), first.end(), [](unsigned char c) { return std::isxdigit(c) != 0; });
}

/// Lower-case words: split at what is no letter and before a capital after a small letter; numbers dropped.
std::vector<std::string> words_of(std::string_view name) {
  std::vector<std::string> words{""};
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto c = static_cast<unsigned char>(name[i]);
    const bool starts = std::isupper(c) && i > 0 && std::islower(static_cast<unsigned char>(name[i - 1]));
    if (!std::isalpha(c) || starts) words.emplace_back();
    if (std::isalpha(c)) words.back() += static_cast<char>(std::tolower(c));
  }
  std::erase(words, "");
  return words;
}

SceneModel model_from_json(JsonReader& reader, const JsonAt& at) {
  SceneModel model;
  if (!at.json.is_object()) reader.fail(at, "expected an object with category, size or mass");
  if (const auto f = given(at, "category")) model.category = reader.text(*f);
  if (const auto f = given(at, "size")) {
    model.size = reader.vec3(*f);
    if (!reader.error() && model.size.minCoeff() < 0) reader.fail(*f, "expected three lengths >= 0");
  }
  if (const auto f = given(at, "mass")) {
    model.mass = reader.number(*f);
    if (!reader.error() && model.mass < 0) reader.fail(*f, "expected a mass >= 0");
  }
  return model;
}

bool is_csv(const std::string& where) { return where.ends_with(".csv") || where.ends_with(".csv.gz"); }

Result<SceneModels> read_hssd_table(const std::string& where, std::string_view text) {
  const CsvFile table = read_csv(where, text);
  if (!table.errors.empty()) return table.errors.front();
  const auto column = [&](std::string_view name) {
    return std::find_if(table.header.begin(), table.header.end(),
                        [&](const CsvCell& one) { return one.text == name; }) -
           table.header.begin();
  };
  const auto columns = static_cast<std::ptrdiff_t>(table.header.size());
  const auto id = column("id");
  std::ptrdiff_t category = columns;
  for (const char* name : {"clean_category", "main_category", "category"}) {
    if (category == columns) category = column(name);
  }
  if (id == columns || category == columns)
    return Error{Error::Kind::Schema, where, {1, 1}, "expected the columns id and clean_category or main_category"};
  SceneModels models;
  for (const CsvRow& row : table.rows) {
    SceneModel model;
    model.category = row[static_cast<std::size_t>(category)].text;
    models.insert_or_assign(std::string(bare_template(row[static_cast<std::size_t>(id)].text)), std::move(model));
  }
  return models;
}

}  // namespace

std::string_view bare_template(std::string_view name) {
  if (const auto slash = name.find_last_of('/'); slash != std::string_view::npos) name.remove_prefix(slash + 1);
  return name.substr(0, name.find('.'));
}

std::string habitat_category(std::string_view name, const Knowledge& knowledge, const FormatFacts& facts) {
  name = bare_template(name);
  if (is_hash(name)) return "";
  constexpr std::string_view kReplicaCad = "frl_apartment_";
  if (name.starts_with(kReplicaCad)) name.remove_prefix(kReplicaCad.size());
  std::vector<std::string> words = words_of(name);
  std::string whole = join(words, "_");
  if (const auto word = facts.replicacad_words.find(whole); word != facts.replicacad_words.end()) return word->second;
  for (; !words.empty(); words.erase(words.begin())) {
    std::string rest = join(words, "_");
    if (knowledge.find(rest) != nullptr) return rest;
  }
  return whole;
}

SceneModels scene_models_from_json(JsonReader& reader, const JsonAt& table) {
  SceneModels models;
  const auto* fields = table.json.get_ptr<const Json::object_t*>();
  if (fields == nullptr) {
    reader.fail(table, "expected an object of templates by name");
    return models;
  }
  for (const auto& [name, model] : *fields) {
    models.emplace(bare_template(name), model_from_json(reader, JsonAt{model, &table, name, 0}));
    if (reader.error()) break;
  }
  return models;
}

Result<SceneModels> read_scene_models(const std::string& where, std::string_view text) {
  if (is_csv(where)) return read_hssd_table(where, text);
  const auto json = parse_json(where, text, limits::kJsonHomeFields);
  if (!json) return json.error();
  JsonReader reader(where);
  const JsonAt root{*json};
  std::optional<JsonAt> table = given(root, "templates");
  if (!table) table.emplace(given(root, "objects").value_or(root));
  SceneModels models = scene_models_from_json(reader, *table);
  if (reader.error()) return *reader.error();
  return models;
}

Result<SceneModels> read_behavior_inventory(const std::string& where, std::string_view text) {
  auto models = read_scene_models(where, text);
  if (!models) return models;
  for (auto& [name, model] : *models) {
    model.category = name.substr(0, name.rfind('-'));
    std::swap(model.size.x(), model.size.y());
  }
  return models;
}

}  // namespace unietp
