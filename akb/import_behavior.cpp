#include "akb/import_behavior.h"

#include <nlohmann/json.hpp>

#include <algorithm>

#include "akb/group_phrases.h"
#include "akb/importers.h"
#include "akb/metadata_json.h"
#include "akb/wordnet_words.h"

namespace unietp {
namespace {

using behavior::Metadata;

/// A category of curated/behavior/category.csv is a word of the lexicon with the metadata's size and mass.
RawCategory listed(const std::string& name, const behavior::Facts& facts) {
  RawCategory raw;
  std::vector<Vec3> boxes;
  for (const auto& [model, size] : facts.models) boxes.push_back(size);
  if (!boxes.empty()) raw.extents = median(boxes);
  raw.extents_source = behavior::kInventory;
  if (facts.mass > 0) raw.mass = facts.mass;
  raw.mass_source = facts.weighed ? std::string("curated") : behavior::kTable;
  constexpr double kHeaviestPick_kg = 15, kLargestPick_m = 1.0;
  raw.movable = !facts.properties.contains("sceneObject") && facts.mass <= kHeaviestPick_kg &&
                (!raw.extents || raw.extents->maxCoeff() <= kLargestPick_m);
  raw.name = name;
  raw.source = {behavior::kTable, 1};
  return raw;
}

/// Any other is a word made of its hypernyms, name and models.
RawCategory derived(const std::string& name, const behavior::Facts& facts, const behavior::Words& words,
                    const WordNetWords& wordnet) {
  RawCategory raw;
  raw.name = name;
  raw.word = words.word(name);
  raw.movable = raw.word->category.movable;
  raw.display = raw.word->category.display;
  if (wordnet.has(facts.synset)) raw.word->category.synset = facts.synset;
  raw.source = facts.mass > 0 ? Source{behavior::kTable, 1} : Source{behavior::kInventory, 1};
  return raw;
}

void add_aliases(TableBuilder& builder, const Metadata& metadata, const behavior::Words& words,
                 const WordNetWords& wordnet, const GroupPhrases& phrases) {
  for (const auto& name : builder.names()) {
    for (auto& word : wordnet.usual_words(metadata.categories.at(name).synset)) {
      builder.alias({name, std::move(word), AliasKind::Synonym, {"derived:wordnet", 0.7}});
    }
    if (!builder.find(name)->movable) continue;
    auto groups = words.chain(name);
    groups.push_back(builder.kind(name));
    for (const AliasKind kind : {AliasKind::Function, AliasKind::Context}) {
      for (const auto& text : phrases.of(groups, kind)) builder.alias({name, text, kind, {"derived:kind", 0.7}});
    }
  }
}

/// All models, but for the shells of BEHAVIOR's own buildings.
void add_models(TableBuilder& builder, const Metadata& metadata, const NameTexts& shells) {
  for (const auto& name : builder.names()) {
    if (shells.contains(name)) continue;
    for (const auto& [model, size] : metadata.categories.at(name).models) {
      builder.model({model, name, size, {behavior::kInventory, 1}});
    }
  }
}

}  // namespace

Result<Tables> import_behavior(const std::filesystem::path& upstream, const std::filesystem::path& curated,
                               const AbsurdPlace& absurd) {
  const auto folder = upstream / "behavior";
  const auto annotations = read_metadata_json(folder / "propagated_annots_params.json.gz");
  if (!annotations) return annotations.error();
  const auto transitions = read_metadata_json(folder / "transition_maps.json.gz");
  if (!transitions) return transitions.error();
  const auto metadata = behavior::read_behavior(folder, curated / "behavior", *annotations);
  if (!metadata) return metadata.error();
  behavior::SubstanceFacts substances;
  NameTexts shells;
  for (const auto& [name, texts] : {std::pair<const char*, NameTexts*>{"squeezed.csv", &substances.squeezed},
                                    {"substance_words.csv", &substances.words},
                                    {"soaps.csv", &substances.soaps},
                                    {"shells.csv", &shells}}) {
    auto read = read_name_texts(curated / "behavior" / name);
    if (!read) return read.error();
    *texts = std::move(*read);
  }
  const auto wordnet = WordNetWords::read(WordNetWords::kFolder);
  if (!wordnet) return wordnet.error();

  TableBuilder builder(Simulator::Behavior, curated);
  builder.refuse(absurd);
  const behavior::Words words(curated, *metadata, builder.errors());
  const GroupPhrases phrases = read_group_phrases(curated / "phrases.csv", builder.errors());
  if (!builder.errors().empty()) return builder.errors().front();
  const auto names = builder.curated_names();
  const std::set<std::string> usual(names.begin(), names.end());
  for (const auto& name : names) {
    if (!metadata->categories.contains(name)) {
      return Error{Error::Kind::Schema,
                   (curated / "behavior" / "category.csv").string(),
                   {},
                   "no BEHAVIOR category '" + name + "'; expected one of category_mapping.csv"};
    }
  }
  for (const auto& [name, facts] : metadata->categories) {
    builder.add(usual.contains(name) ? listed(name, facts) : derived(name, facts, words, *wordnet));
  }
  builder.prefer(usual);
  builder.keep_best({{Predicate::On, 8}, {Predicate::Inside, 7}, {Predicate::NextTo, 5}, {Predicate::Under, 3}});
  builder.kept_like(words.like());
  behavior::add_affordances(builder, *metadata, *transitions);
  builder.place_by_kind(1);
  behavior::add_effects(builder, *metadata, *annotations, *transitions, substances);
  add_models(builder, *metadata, shells);
  add_aliases(builder, *metadata, words, *wordnet, phrases);
  return builder.finish();
}

}  // namespace unietp
