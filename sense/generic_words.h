#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "sense/kinds.h"

namespace unietp {

/// Names of categories that people take for names of a whole kind: a "piece of fruit" may be an apple. Read only after
/// loading.
class GenericWords {
 public:
  GenericWords() = default;
  /// By the word, in the form of words.csv: the kinds that it names.
  explicit GenericWords(std::map<std::string, std::vector<std::string>, std::less<>> names)
      : names_(std::move(names)) {}

  /// Whether the name, in any form that normal_word takes, may mean a thing of the kind.
  bool may_mean(std::string_view name, std::string_view kind, const Kinds& kinds) const;
  bool contains(std::string_view name) const;

 private:
  std::map<std::string, std::vector<std::string>, std::less<>> names_;
};

/// Reads generic_words.csv (words,kinds,source): names of categories and kinds, both separated by `|`. Errors are
/// appended: Io, Parse; Schema for an unknown kind, and for a word that stands twice.
GenericWords read_generic_words(const std::filesystem::path& path, const Kinds& kinds, std::vector<Error>& errors);

}  // namespace unietp
