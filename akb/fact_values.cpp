#include "akb/fact_values.h"

#include <algorithm>
#include <charconv>

#include "core/limits.h"
#include "core/text.h"

namespace unietp {

std::optional<double> number_in(std::string_view text, double most) {
  double number = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (code != std::errc() || end != text.data() + text.size() || !(number > 0) || !(number <= most))
    return std::nullopt;
  return number;
}

std::optional<int> count_in(std::string_view text) {
  int number = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (code != std::errc() || end != text.data() + text.size() || number < 1) return std::nullopt;
  return number;
}

std::optional<Vec3> size_in(const std::string& text) {
  const auto parts = split(text, 'x');
  if (parts.size() != 3) return std::nullopt;
  Vec3 size;
  for (int axis = 0; axis < 3; ++axis) {
    const auto length = number_in(trim(parts[static_cast<std::size_t>(axis)]), limits::kCategory_m);
    if (!length) return std::nullopt;
    size[axis] = *length;
  }
  return size;
}

std::optional<bool> flag_in(std::string_view text) {
  if (text == "true") return true;
  if (text == "false") return false;
  return std::nullopt;
}

/// Words joined by |, each one of `accepted` unless that is empty; nothing when one is not.
std::optional<std::vector<std::string>> words_in(const std::string& text, const std::vector<std::string>& accepted) {
  if (text.empty()) return std::vector<std::string>{};
  auto words = split(text, '|');
  for (const auto& word : words) {
    if (word.empty() || trim(word) != word) return std::nullopt;
    if (!accepted.empty() && std::find(accepted.begin(), accepted.end(), word) == accepted.end()) return std::nullopt;
  }
  return words;
}

bool is_synset(std::string_view text) {  // lemma.pos.number
  const auto parts = split(text, '.');
  return parts.size() >= 3 && !parts.front().empty() && parts[parts.size() - 2].size() == 1 &&
         parts.back().size() == 2 && text.find_first_of(" \t") == std::string_view::npos;
}

}  // namespace unietp
