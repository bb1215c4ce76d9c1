#include "sense/category_kinds.h"

#include "akb/row_reader.h"
#include "core/files.h"
#include "core/text.h"
#include "scene/simulator.h"

namespace unietp {
namespace {

constexpr std::string_view kHalf = "half_";

std::optional<KindFact> kind_of(const Category& category, Simulator simulator, const Kinds& kinds,
                                const WordKinds& words, const Hypernyms& net) {
  const auto list = name_of(simulator);
  for (const auto& name : {category.name, category.display}) {
    if (const auto kind = words.of_word(name, list)) {
      const auto wide = words.of_synset(category.synset, net);
      return wide && wide->kind == *kind ? *wide : KindFact{*kind, "curated"};
    }
    if (!name.starts_with(kHalf)) continue;
    if (const auto whole = words.of_word(name.substr(kHalf.size()), list))
      return KindFact{kinds.piece_of(*whole), "curated"};
  }
  return words.of_synset(category.synset, net);
}

}  // namespace

Result<CategoryKinds> find_category_kinds(const std::vector<Knowledge>& knowledge, const Kinds& kinds,
                                          const WordKinds& words, const Hypernyms& net) {
  CategoryKinds all;
  std::vector<std::string> without;
  for (const auto& simulator : knowledge) {
    for (const auto& category : simulator.categories()) {
      if (auto kind = kind_of(category, simulator.simulator(), kinds, words, net)) {
        all.emplace(std::pair(simulator.simulator(), category.name), std::move(*kind));
      } else {
        without.push_back(std::string(name_of(simulator.simulator())) + ":" + category.name);
      }
    }
  }
  if (!without.empty())
    return Error{Error::Kind::Schema, "data/sense/words.csv", {}, "expected a kind for: " + join(without, ", ")};
  return all;
}

CategoryKinds read_category_kinds(const std::filesystem::path& path, const Kinds& kinds, std::vector<Error>& errors) {
  CategoryKinds all;
  const auto text = read_file(path);
  if (!text) {
    errors.push_back(text.error());
    return all;
  }
  std::vector<std::string> names;
  for (const auto simulator : kSimulators) names.emplace_back(name_of(simulator));
  RowReader row(path.string(), *text, {"simulator", "category", "kind", "source"}, errors);
  for (const auto& cells : row.rows()) {
    row.at(cells);
    const auto simulator = row.value_of("simulator", names, "simulator", simulator_named);
    const auto category = row.required("category");
    const auto kind = row.required("kind");
    if (kinds.find(kind) == nullptr) row.fail("kind", "'" + kind + "' is not a kind of kinds.csv");
    if (row.sound()) all[{simulator, category}] = {kind, row.required("source")};
  }
  return all;
}

std::string csv_of(const CategoryKinds& categories) {
  std::string text = csv_line({"simulator", "category", "kind", "source"});
  for (const auto& [key, fact] : categories)
    text += csv_line({std::string(name_of(key.first)), key.second, fact.kind, fact.source});
  return text;
}

}  // namespace unietp
