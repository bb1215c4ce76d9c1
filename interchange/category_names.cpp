#include "interchange/category_names.h"

#include <cctype>

#include "core/text.h"

namespace unietp {
namespace {

std::string letters_of(std::string_view name) {
  std::string letters;
  for (const char c : lower(name)) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) letters += c;
  }
  return letters;
}

}  // namespace

CategoryNames::CategoryNames(const Knowledge& knowledge) : knowledge_(&knowledge) {
  const auto add = [&](std::string_view name, const Category* category) {
    by_letters_.try_emplace(letters_of(name), category);
  };
  for (const Category& category : knowledge.categories()) add(category.name, &category);
  for (const Category& category : knowledge.categories()) add(category.display, &category);
  for (const Category& category : knowledge.categories()) add(category.plural, &category);
  for (const Alias& alias : knowledge.aliases()) {
    if (alias.kind == AliasKind::Synonym) add(alias.text, knowledge.find(alias.category));
  }
  by_letters_.erase("");
}

const Category* CategoryNames::find(std::string_view name) const {
  if (const Category* exact = knowledge_->find(name)) return exact;
  const auto found = by_letters_.find(letters_of(name));
  return found == by_letters_.end() ? nullptr : found->second;
}

bool is_of_the_building(std::string_view name, const FormatFacts& facts) {
  return facts.building_words.contains(letters_of(name));
}

}  // namespace unietp
