#pragma once

#include <map>
#include <string>
#include <string_view>

#include "akb/knowledge.h"
#include "core/result.h"
#include "interchange/format_facts.h"
#include "interchange/source_scene.h"
#include "scene/json_reader.h"

namespace unietp {

/// What a model is that scene files only name.
struct SceneModel {
  std::string category;      // "" when not known
  Vec3 size = Vec3::Zero();  // full extents in the object frame: width, depth, height, meters; zero when not known
  double mass = 0;           // kilograms, 0 when not known
  bool operator==(const SceneModel&) const = default;
};
/// By the bare name of the model (bare_template).
using SceneModels = std::map<std::string, SceneModel, std::less<>>;

/// `{"frl_apartment_bowl_01": {"category": "bowl", "size": [w, d, h], "mass": 0.3}, …}`, each field optional, others
/// passed over, as a whole or in a field `templates` or `objects`. Names without folders and endings. A file called
/// *.csv or *.csv.gz is read as one of HSSD's own tables: the columns `id` and, the first that there is of them,
/// `clean_category`, `main_category` or `category`; others are passed over. Errors: Parse, Schema with a JSON pointer
/// or the place in the table.
Result<SceneModels> read_scene_models(const std::string& where, std::string_view text);
/// The same from a table that stands inside a file; errors go to the reader.
SceneModels scene_models_from_json(JsonReader& reader, const JsonAt& table);

/// The same of BEHAVIOR's inventory of models: named `category-model`, sizes along the models' own axes, fronts along
/// x.
Result<SceneModels> read_behavior_inventory(const std::string& where, std::string_view text);

/// read_behavior with a table of models.
Result<std::vector<SourceScene>> read_behavior(const std::string& where, std::string_view text,
                                               const Knowledge& knowledge, const SceneModels& models);

/// read_habitat with a table of templates, for scenes whose template names are hashes and to have real sizes. It wins
/// over names and over the models of the knowledge base; what stands in the scene file itself wins over it.
Result<std::vector<SourceScene>> read_habitat(const std::string& where, std::string_view text,
                                              const Knowledge& knowledge, const FormatFacts& facts,
                                              const SceneModels& models);

/// "objects/frl_apartment_bowl_01.object_config.json" → "frl_apartment_bowl_01".
std::string_view bare_template(std::string_view name);

/// The category that a template's name speaks of: without its data set's prefix and its numbers, then without its first
/// words until the knowledge base has it, or by FormatFacts::replicacad_words ("sofa" is a couch). What no rule knows
/// comes back as the words that are left; "" for a hash.
std::string habitat_category(std::string_view name, const Knowledge& knowledge, const FormatFacts& facts);

}  // namespace unietp
