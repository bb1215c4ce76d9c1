#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace unietp {

/// The nouns of WordNet 3.0 as Debian's wordnet-base installs them, with what each is a kind of. No gloss is read.
class Hypernyms {
 public:
  static constexpr const char* kFolder = "/usr/share/wordnet";

  /// Reads index.noun and data.noun. Errors: Io, naming the file.
  static Result<Hypernyms> read(const std::filesystem::path& folder);

  /// The synset and all above it, as places in data.noun, nearest first (breadth first in WordNet's order); empty for
  /// an unknown one. `synset`: "mug.n.04".
  std::vector<std::size_t> lineage(std::string_view synset) const;
  /// The place of a synset in data.noun; npos for an unknown one.
  std::size_t place_of(std::string_view synset) const;

 private:
  std::map<std::string, std::vector<std::size_t>, std::less<>> senses_;  // by lemma, first sense first
  std::map<std::size_t, std::vector<std::size_t>> above_;
};

}  // namespace unietp
