#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace unietp {

/// The nouns of WordNet 3.0 as Debian's wordnet-base installs them (index.noun, data.noun). Only the words are read, no
/// gloss.
class WordNetWords {
 public:
  static constexpr const char* kFolder = "/usr/share/wordnet";

  /// Errors: Io, naming the file.
  static Result<WordNetWords> read(const std::filesystem::path& folder);

  /// True for a synset such as "mug.n.04" whose word has that many senses.
  bool has(std::string_view synset) const;
  /// Plain words of the synset of which it is the first sense, in WordNet's order: lower case, letters, spaces and
  /// hyphens only. "mug.n.04" gives none, "sofa.n.01" gives sofa, couch, lounge.
  std::vector<std::string> usual_words(std::string_view synset) const;

 private:
  std::map<std::string, std::vector<std::size_t>, std::less<>> senses_;  // lemma -> bytes in data_, first sense first
  std::string data_;
};

}  // namespace unietp
