#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace unietp {

/// The nouns of WordNet 3.0 with the number of their senses.
class WordNet {
 public:
  /// Reads `<folder>/index.noun` (Debian: /usr/share/wordnet, package wordnet-base); nothing when it is not there.
  static std::optional<WordNet> read(const std::filesystem::path& folder);
  /// `mug.n.04`: a noun that has so many senses.
  bool has(std::string_view synset) const;

 private:
  std::map<std::string, int, std::less<>> senses_;  // by lemma
};

/// Lemma and number of a synset's name; nothing when it is not of the form `coffee_mug.n.01`.
struct SynsetName {
  std::string lemma;
  int sense = 0;  // >= 1
};
/// nullopt when the text has another form.
std::optional<SynsetName> synset_named(std::string_view synset);

}  // namespace unietp
