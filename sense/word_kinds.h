#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "sense/hypernyms.h"
#include "sense/kinds.h"

namespace unietp {

/// A kind and where it is known from: `curated` or `derived:wordnet:<synset>`.
struct KindFact {
  std::string kind, source;
  bool operator==(const KindFact&) const = default;
};

/// A word in the form of words.csv: small letters, parts joined by underscores. "CoffeeMachine", "coffee machine" and
/// "coffee-machine" give "coffee_machine".
std::string normal_word(std::string_view name);

/// What kind of thing a word means: the words of data/sense/words.csv, and for synsets the nearest of
/// data/sense/hypernyms.csv.
class WordKinds {
 public:
  /// `words` and `synsets` name kinds of the taxonomy.
  WordKinds(std::map<std::string, std::string, std::less<>> words, std::map<std::string, std::string> synsets);

  /// The kind that words.csv gives a word; the rows of `list` ("programs", a simulator) come before those of all.
  std::optional<std::string> of_word(std::string_view word, std::string_view list = "") const;
  /// The kind of the nearest synset at or above this one.
  std::optional<KindFact> of_synset(std::string_view synset, const Hypernyms& net) const;

 private:
  std::map<std::string, std::string, std::less<>> words_;
  std::map<std::string, std::string> synsets_;
};

/// Reads words.csv (word,kind,source) and hypernyms.csv (synset,kind,source) of a folder. Errors are appended: a kind
/// that the taxonomy has not, a word that stands twice.
WordKinds read_word_kinds(const std::filesystem::path& folder, const Kinds& kinds, std::vector<Error>& errors);

}  // namespace unietp
