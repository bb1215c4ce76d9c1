#include "akb/category_words.h"

#include <algorithm>

#include "core/text.h"

namespace unietp {
namespace {

bool has(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

/// "water_bottle" for "water bottle" and "Water bottle".
std::string member_word(std::string_view display) {
  auto word = replace_all(lower(display), " ", "_");
  return replace_all(word, "-", "_");
}

}  // namespace

bool names_category(const std::vector<std::string>& words, const Category& category) {
  return has(words, lower(category.name)) || has(words, member_word(category.display));
}

bool names_any_category(const std::string& word, const std::vector<Tables>& all) {
  return std::any_of(all.begin(), all.end(), [&](const Tables& tables) {
    return std::any_of(tables.categories.begin(), tables.categories.end(),
                       [&](const Category& category) { return names_category({word}, category); });
  });
}

}  // namespace unietp
