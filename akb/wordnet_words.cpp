#include "akb/wordnet_words.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>

#include "core/files.h"
#include "core/text.h"

namespace unietp {
namespace {

template <class Number>
std::optional<Number> number_of(std::string_view text, int base = 10) {
  Number number{};
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), number, base);
  if (failed != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

std::vector<std::string> words_of_line(std::string_view line) {
  std::istringstream stream{std::string(line)};
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(std::move(word));
  return words;
}

/// "mug.n.04" -> mug, 3.
struct Sense {
  std::string lemma;
  std::size_t number = 0;
};
std::optional<Sense> sense_of(std::string_view synset) {
  const auto dot = synset.rfind(".n.");
  if (dot == std::string_view::npos) return std::nullopt;
  const auto number = number_of<std::size_t>(synset.substr(dot + 3));
  if (!number || *number == 0) return std::nullopt;
  return Sense{lower(synset.substr(0, dot)), *number - 1};
}

bool plain(std::string_view word) {
  return std::all_of(word.begin(), word.end(), [](char c) { return (c >= 'a' && c <= 'z') || c == ' ' || c == '-'; });
}

}  // namespace

Result<WordNetWords> WordNetWords::read(const std::filesystem::path& folder) {
  WordNetWords net;
  const auto index = read_file(folder / "index.noun");
  if (!index) return index.error();
  auto data = read_file(folder / "data.noun");
  if (!data) return data.error();
  net.data_ = std::move(*data);
  for (const auto& line : split(*index, '\n')) {
    if (line.empty() || line.front() == ' ') continue;  // the license
    const auto words = words_of_line(line);
    const auto count = words.size() > 2 ? number_of<std::size_t>(words[2]) : std::nullopt;
    if (!count || words.size() < *count) continue;
    auto& senses = net.senses_[words.front()];
    for (std::size_t i = words.size() - *count; i < words.size(); ++i) {
      senses.push_back(number_of<std::size_t>(words[i]).value_or(net.data_.size()));
    }
  }
  return net;
}

bool WordNetWords::has(std::string_view synset) const {
  const auto sense = sense_of(synset);
  if (!sense) return false;
  const auto found = senses_.find(sense->lemma);
  return found != senses_.end() && sense->number < found->second.size();
}

std::vector<std::string> WordNetWords::usual_words(std::string_view synset) const {
  if (!has(synset)) return {};
  const auto sense = *sense_of(synset);
  const auto at = senses_.find(sense.lemma)->second[sense.number];
  if (at >= data_.size()) return {};
  // offset, file, "n", count in hexadecimal, then word and lexical id by turns.
  const auto fields = words_of_line(std::string_view(data_).substr(at, data_.find('\n', at) - at));
  const auto count = fields.size() > 3 ? number_of<std::size_t>(fields[3], 16).value_or(0) : 0;
  std::vector<std::string> words;
  for (std::size_t i = 0; i < count && 4 + 2 * i < fields.size(); ++i) {
    const auto& lemma = fields[4 + 2 * i];
    const auto found = senses_.find(lower(lemma));
    const bool first = found != senses_.end() && !found->second.empty() && found->second.front() == at;
    const auto word = replace_all(lemma, "_", " ");
    if (first && plain(word)) words.push_back(word);
  }
  return words;
}

}  // namespace unietp
