#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "akb/import_common.h"
#include "akb/metadata_json.h"
#include "core/result.h"

// The parts of import_behavior: what the files say, the words made of it, and what things do.
namespace unietp::behavior {

/// Sources of facts: the files of upstream/behavior.
inline const std::string kTable = "metadata:category_mapping.csv.gz",
                         kAnnotations = "metadata:propagated_annots_params.json.gz",
                         kInventory = "metadata:object_inventory.json.gz",
                         kSlicing = "metadata:transition_maps.json.gz";

/// One category as BEHAVIOR's files describe it.
struct Facts {
  std::string synset;                                // BEHAVIOR's own: of WordNet or custom ("half__apple.n.01")
  double mass = 0;                                   // kilograms; 0 when no file has it
  bool weighed = false;                              // the mass is our own: that of the file is out of proportion
  std::vector<std::pair<std::string, Vec3>> models;  // name and box: width, depth, height in meters
  std::set<std::string> properties;                  // of its synset
  std::set<std::string> links;                       // of any of its models: joint, togglebutton, fillable, ...
  std::set<std::string> substances;                  // that it applies or pours
  std::vector<std::string> rooms;                    // of homes in which it stands, most usual first
  std::set<std::string> denied;  // affordances that annotations give its synset and our own list says it lacks
};

/// Whether OmniGibson opens it: a model has a joint and the synset is annotated as openable. A wardrobe or a freezer is
/// not, though a model of it has doors, so that BEHAVIOR's tasks put things into it as into a shelf.
bool opens(const Facts& facts);

/// All that the files of BEHAVIOR say.
struct Metadata {
  std::map<std::string, Facts> categories;      // all that are objects
  std::map<std::string, std::string> hypernym;  // synset -> the first one above it
};

/// Reads the files of upstream/behavior, and our lists in curated/behavior; `annotations` as
/// propagated_annots_params.json.gz holds them. Errors: Io, Parse, Schema.
Result<Metadata> read_behavior(const std::filesystem::path& folder, const std::filesystem::path& curated,
                               const nlohmann::json& annotations);

/// Makes a word for each category out of hypernyms, name and models by the tables in curated/behavior: see
/// docs/knowledge.md. Errors are appended.
class Words {
 public:
  Words(const std::filesystem::path& curated, const Metadata& metadata, std::vector<Error>& errors);
  /// What a category is called, what kind of thing it is, and its body. It must be one of the metadata.
  Word word(const std::string& name) const;
  /// Kinds that are kept in the same places as another.
  const std::map<std::string, std::string>& like() const { return like_; }
  /// The category's synset and all above it, nearest first.
  std::vector<std::string> chain(const std::string& name) const;

 private:
  struct Row {
    std::string key;  // a synset, a pattern or a name
    std::map<std::string, std::string> cells;
  };
  std::string cell(const std::string& name, const std::string& column) const;
  std::string display(const std::string& name) const;
  const Row* form(const std::string& name, std::string* content = nullptr) const;
  const Row* row_of_content(const std::string& content) const;
  static std::vector<Row> read_rows(const std::filesystem::path& path, const std::vector<std::string>& columns,
                                    std::vector<Error>& errors);

  const Metadata& metadata_;
  std::map<std::string, Row> hypernyms_, names_;
  std::vector<Row> forms_, contents_;
  std::map<std::string, std::vector<std::string>> kind_rooms_;
  std::map<std::string, std::string> like_;
  std::set<std::string> food_;  // kinds of food
};

/// Size of a body of this archetype made of the models' boxes, upright and at rest; the archetype changes when the
/// boxes do not suit it (a flat bottle is a box).
struct Body {
  Archetype archetype = Archetype::Box;
  Vec3 size = Vec3::Zero();
  Source source;
};
Body body_of(const Facts& facts, Archetype wanted);

/// What slicing makes of a category, by BEHAVIOR's rules: two halves.
struct Pieces {
  std::string category;
  int amount = 0;
};
/// By category, for those of the builder that are sliced.
std::map<std::string, Pieces> pieces_of(const TableBuilder& builder, const Metadata& metadata,
                                        const nlohmann::json& transitions);

/// Adds the affordances that annotations and models show, then those by archetype. Call it after all categories.
void add_affordances(TableBuilder& builder, const Metadata& metadata, const nlohmann::json& transitions);
/// What the annotations do not tell of substances.
struct SubstanceFacts {
  NameTexts squeezed;  // bottles that apply what is in them, though no model says so
  NameTexts words;     // what we call a substance that BEHAVIOR calls otherwise
  NameTexts soaps;     // cleaners that are applied to what is washed up
};
void add_effects(TableBuilder& builder, const Metadata& metadata, const nlohmann::json& annotations,
                 const nlohmann::json& transitions, const SubstanceFacts& known);

}  // namespace unietp::behavior
