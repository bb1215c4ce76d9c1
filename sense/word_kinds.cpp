#include "sense/word_kinds.h"

#include <algorithm>

#include "akb/row_reader.h"
#include "core/files.h"
#include "core/text.h"

namespace unietp {
namespace {

bool is_small(char c) { return c >= 'a' && c <= 'z'; }
bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }

std::map<std::string, std::string, std::less<>> read_rows(const std::filesystem::path& path, const std::string& key,
                                                          const Kinds& kinds, std::vector<Error>& errors) {
  std::map<std::string, std::string, std::less<>> all;
  const auto text = read_file(path);
  if (!text) {
    errors.push_back(text.error());
    return all;
  }
  RowReader row(path.string(), *text, {key, "kind", "source"}, errors);
  for (const auto& cells : row.rows()) {
    row.at(cells);
    const auto word = row.required(key);
    const auto kind = row.required("kind");
    if (kinds.find(kind) == nullptr) row.fail("kind", "'" + kind + "' is not a kind of kinds.csv");
    if (!all.emplace(word, kind).second) row.fail(key, "'" + word + "' stands twice");
  }
  return all;
}

}  // namespace

std::string normal_word(std::string_view name) {
  std::string word;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    if (c == '\'') continue;
    if (is_capital(c) && i > 0 && is_small(name[i - 1])) word += '_';
    word += c == ' ' || c == '-' ? '_' : c;
  }
  return lower(word);
}

WordKinds::WordKinds(std::map<std::string, std::string, std::less<>> words, std::map<std::string, std::string> synsets)
    : words_(std::move(words)), synsets_(std::move(synsets)) {}

std::optional<std::string> WordKinds::of_word(std::string_view word, std::string_view list) const {
  const auto normal = normal_word(word);
  if (!list.empty()) {
    if (const auto own = words_.find(std::string(list) + ":" + normal); own != words_.end()) return own->second;
  }
  const auto found = words_.find(normal);
  if (found == words_.end()) return std::nullopt;
  return found->second;
}

std::optional<KindFact> WordKinds::of_synset(std::string_view synset, const Hypernyms& net) const {
  const auto line = net.lineage(synset);
  std::optional<KindFact> nearest;
  std::size_t best = line.size();
  for (const auto& [name, kind] : synsets_) {
    const auto at = std::find(line.begin(), line.end(), net.place_of(name)) - line.begin();
    if (static_cast<std::size_t>(at) >= best) continue;
    best = static_cast<std::size_t>(at);
    nearest = KindFact{kind, "derived:wordnet:" + name};
  }
  return nearest;
}

WordKinds read_word_kinds(const std::filesystem::path& folder, const Kinds& kinds, std::vector<Error>& errors) {
  auto words = read_rows(folder / "words.csv", "word", kinds, errors);
  const auto synsets = read_rows(folder / "hypernyms.csv", "synset", kinds, errors);
  return {std::move(words), {synsets.begin(), synsets.end()}};
}

}  // namespace unietp
