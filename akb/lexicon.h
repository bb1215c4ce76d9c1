#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "akb/knowledge.h"

namespace unietp {

/// A household word with what is true of it in any simulator (data/akb/curated/lexicon*.csv); `kind` groups words that
/// are kept in the same places ("cutlery").
struct Word {
  Category category;  // name empty; size and mass are typical ones
  std::string kind;
};

using Lexicon = std::map<std::string, Word, std::less<>>;  // by display name

/// "mug" -> "mugs", "bottle of wine" -> "bottles of wine". Irregular plurals stand in the table.
std::string regular_plural(std::string_view display);

/// The files `<folder>/<stem>*.csv` in the order of their names: one table kept in several files. Errors: Io when there
/// is none.
std::vector<std::filesystem::path> parts_of(const std::filesystem::path& folder, std::string_view stem,
                                            std::vector<Error>& errors);

/// Reads kinds.csv: the usual rooms of each kind. Errors are appended.
std::map<std::string, std::vector<std::string>> read_kind_rooms(const std::filesystem::path& path,
                                                                std::vector<Error>& errors);

/// Reads lexicon*.csv and kinds.csv (usual rooms of a kind). Errors: as read_tables; a word that two files have.
Lexicon read_lexicon(const std::filesystem::path& curated, std::vector<Error>& errors);

}  // namespace unietp
