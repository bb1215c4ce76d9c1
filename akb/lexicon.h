#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "akb/knowledge.h"

namespace unietp {

/// A household word with what is true of it in any simulator (data/akb/curated/lexicon.csv); `kind` groups words that
/// are kept in the same places ("cutlery").
struct Word {
  Category category;  // name empty; size and mass are typical ones
  std::string kind;
};

using Lexicon = std::map<std::string, Word, std::less<>>;  // by display name

/// "mug" -> "mugs", "bottle of wine" -> "bottles of wine". Irregular plurals stand in the table.
std::string regular_plural(std::string_view display);

/// Reads lexicon.csv and kinds.csv (usual rooms of a kind). Errors: as read_tables.
Lexicon read_lexicon(const std::filesystem::path& curated, std::vector<Error>& errors);

}  // namespace unietp
