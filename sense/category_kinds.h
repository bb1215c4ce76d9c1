#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "akb/knowledge.h"
#include "core/result.h"
#include "sense/word_kinds.h"

namespace unietp {

/// The kind of every category of every simulator.
using CategoryKinds = std::map<std::pair<Simulator, std::string>, KindFact>;

/// Stage: finds the kind of each category. Its name or its display name in words.csv decides; a half has the kind of
/// pieces of the whole. Where WordNet's hypernyms say the same of its synset, that is the source. Errors: Schema,
/// naming the categories that neither gives a kind.
Result<CategoryKinds> find_category_kinds(const std::vector<Knowledge>& knowledge, const Kinds& kinds,
                                          const WordKinds& words, const Hypernyms& net);

/// Reads categories.csv (simulator,category,kind,source). Errors are appended.
CategoryKinds read_category_kinds(const std::filesystem::path& path, const Kinds& kinds, std::vector<Error>& errors);
/// The same table as text.
std::string csv_of(const CategoryKinds& categories);

}  // namespace unietp
