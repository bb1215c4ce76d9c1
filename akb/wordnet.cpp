#include "akb/wordnet.h"

#include <algorithm>
#include <charconv>

#include "core/files.h"
#include "core/text.h"

namespace unietp {

std::optional<WordNet> WordNet::read(const std::filesystem::path& folder) {
  const auto text = read_file(folder / "index.noun");
  if (!text) return std::nullopt;
  WordNet found;
  for (std::size_t at = 0; at < text->size();) {
    const auto end = std::min(text->find('\n', at), text->size());
    const auto line = std::string_view(*text).substr(at, end - at);
    at = end + 1;
    if (line.empty() || line.front() == ' ') continue;    // the license
    const auto lemma = line.substr(0, line.find(" n "));  // "mug n 4 5 @ ..."
    if (lemma.size() == line.size()) continue;
    const auto count = line.substr(lemma.size() + 3);
    int senses = 0;
    std::from_chars(count.data(), count.data() + count.size(), senses);
    found.senses_.emplace(lemma, senses);
  }
  return found;
}

bool WordNet::has(std::string_view synset) const {
  const auto name = synset_named(synset);
  if (!name) return false;
  const auto at = senses_.find(lower(name->lemma));
  return at != senses_.end() && name->sense <= at->second;
}

std::optional<SynsetName> synset_named(std::string_view synset) {
  const auto dot = synset.rfind(".n.");
  if (dot == std::string_view::npos || dot == 0) return std::nullopt;
  const auto lemma = synset.substr(0, dot), number = synset.substr(dot + 3);
  const auto fine = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
           c == '\'' || c == '.';
  };
  if (!std::all_of(lemma.begin(), lemma.end(), fine)) return std::nullopt;
  SynsetName name{std::string(lemma), 0};
  const auto [end, code] = std::from_chars(number.data(), number.data() + number.size(), name.sense);
  const bool reads = code == std::errc() && end == number.data() + number.size() && number.size() == 2;
  if (!reads || name.sense < 1) return std::nullopt;
  return name;
}

}  // namespace unietp
