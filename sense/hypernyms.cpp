#include "sense/hypernyms.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "core/files.h"
#include "core/text.h"

namespace unietp {
namespace {

std::optional<std::size_t> size_of(std::string_view text, int base = 10) {
  std::size_t number = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), number, base);
  if (failed != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

std::vector<std::string> fields_of(const std::string& line) {
  auto fields = split(line, ' ');
  std::erase(fields, "");
  return fields;
}

/// The synsets that a line of data.noun points to by `@` and `@i`. Its fields: offset, file, "n", the number of words
/// in hexadecimal, a word and a lexical id for each, the number of pointers, and for each a sign, an offset, a part of
/// speech and a number.
std::vector<std::size_t> above(const std::vector<std::string>& fields) {
  std::vector<std::size_t> all;
  const auto words = fields.size() > 3 ? size_of(fields[3], 16).value_or(0) : 0;
  const std::size_t at = 4 + 2 * words;
  const auto pointers = at < fields.size() ? size_of(fields[at]).value_or(0) : 0;
  for (std::size_t i = 0; i < pointers && at + 4 * i + 2 < fields.size(); ++i) {
    const auto& sign = fields[at + 4 * i + 1];
    if (sign != "@" && sign != "@i") continue;
    if (const auto offset = size_of(fields[at + 4 * i + 2])) all.push_back(*offset);
  }
  return all;
}

}  // namespace

Result<Hypernyms> Hypernyms::read(const std::filesystem::path& folder) {
  Hypernyms net;
  const auto index = read_file(folder / "index.noun");
  if (!index) return index.error();
  const auto data = read_file(folder / "data.noun");
  if (!data) return data.error();
  for (const auto& line : split(*index, '\n')) {
    if (line.empty() || line.front() == ' ') continue;  // the license
    const auto fields = fields_of(line);
    const auto count = fields.size() > 2 ? size_of(fields[2]).value_or(0) : 0;
    if (fields.size() < count) continue;
    auto& senses = net.senses_[fields.front()];
    for (std::size_t i = fields.size() - count; i < fields.size(); ++i)
      senses.push_back(size_of(fields[i]).value_or(std::string::npos));
  }
  for (const auto& line : split(*data, '\n')) {
    if (line.empty() || line.front() == ' ') continue;
    const auto fields = fields_of(line);
    if (const auto offset = size_of(fields.front())) net.above_[*offset] = above(fields);
  }
  return net;
}

std::size_t Hypernyms::place_of(std::string_view synset) const {
  const auto dot = synset.rfind(".n.");
  if (dot == std::string_view::npos) return std::string::npos;
  const auto number = size_of(synset.substr(dot + 3));
  const auto found = senses_.find(lower(synset.substr(0, dot)));
  if (!number || *number == 0 || found == senses_.end() || *number > found->second.size()) return std::string::npos;
  return found->second[*number - 1];
}

std::vector<std::size_t> Hypernyms::lineage(std::string_view synset) const {
  std::vector<std::size_t> line;
  if (const auto place = place_of(synset); place != std::string::npos) line.push_back(place);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const auto found = above_.find(line[i]);
    if (found == above_.end()) continue;
    for (const auto wider : found->second) {
      if (std::find(line.begin(), line.end(), wider) == line.end()) line.push_back(wider);
    }
  }
  return line;
}

}  // namespace unietp
